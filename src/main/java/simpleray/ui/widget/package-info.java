/** The look of the window, its notices and keys: the parts of Swing that all tasks share. */
package simpleray.ui.widget;
