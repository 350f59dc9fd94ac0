package simpleray.scene;

/** Which OBJ files a scene may name: a scene file that came from elsewhere must not show what lies about on a computer. */
public enum Reach {
    /** Those in the scene file's folder and below it; in the working directory if the scene comes from a stream. */
    FOLDER,
    /** All. */
    ANYWHERE
}
