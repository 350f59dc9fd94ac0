/**
 * Words and numbers of a scene file, with their positions. This package knows no scene; it is the lowest because every class of the
 * thesis (chapter 5) reads itself from a {@link simpleray.text.SceneReader} and writes itself to a
 * {@link simpleray.text.SceneWriter}.
 */
package simpleray.text;
