/**
 * What a scene is made of and how light falls on it (thesis, chapters 3 to 5): objects, materials, lights, the camera, and in
 * {@link simpleray.scene.Scene} the shading itself. A scene is built or read by one thread, and then frozen: while it is rendered
 * any number of threads look at it and none changes it.
 */
package simpleray.scene;
