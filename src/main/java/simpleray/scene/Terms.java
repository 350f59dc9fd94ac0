package simpleray.scene;

/**
 * Which parts of the colour are wanted (thesis, chapter 4 and its figure 10). <em>Constant.</em>
 *
 * @param ambient Ka·GA
 * @param diffuse Kd·LC·(N·L), of each light
 * @param specular Ks·LC·(N·H)^shininess, of each light
 * @param shadows whether an object in the way stops a light
 * @param reflections whether mirror rays and refracted rays are followed
 */
public record Terms(boolean ambient, boolean diffuse, boolean specular, boolean shadows, boolean reflections) {
    /** The finished picture. */
    public static final Terms ALL = new Terms(true, true, true, true, true);

    /** {@return whether any of the lights' terms is wanted} */
    boolean lights() {
        return diffuse || specular;
    }
}
