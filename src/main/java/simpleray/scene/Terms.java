package simpleray.scene;

/**
 * The terms of the colour that a picture shows (thesis, chapter 4 and its figure 10). <em>Constant.</em>
 *
 * @param ambient Ka·GA
 * @param diffuse Kd·LC·(N·L), of each light
 * @param specular Ks·LC·(N·H)^shininess, of each light
 * @param shadows whether an object in the way stops a light
 * @param reflections whether mirror rays and refracted rays are followed
 */
public record Terms(boolean ambient, boolean diffuse, boolean specular, boolean shadows, boolean reflections) {
    /** All terms: the finished picture. */
    public static final Terms ALL = new Terms(true, true, true, true, true);

    /** {@return whether a term depends on lights} */
    public boolean lights() {
        return diffuse || specular;
    }
}
