package simpleray.scene;

/** The OBJ files that a scene may name: a scene file from elsewhere must not show other files of this computer. */
public enum Reach {
    /** Those in the scene file's folder and below it; in the working directory if the scene comes from a stream. */
    FOLDER,
    /** All files. */
    ANYWHERE
}
