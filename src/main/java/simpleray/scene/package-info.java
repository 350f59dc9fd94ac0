/**
 * The scene and its lighting (thesis, chapters 3 to 5): objects, materials, lights, cameras, and in
 * {@link simpleray.scene.WhittedIntegrator} the shading. One thread builds or reads a scene. While it is rendered, any number of
 * threads read it and none changes it.
 */
package simpleray.scene;
