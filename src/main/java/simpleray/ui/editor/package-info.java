/** The scene's text, and its problems. */
package simpleray.ui.editor;
