package simpleray.film;

import simpleray.render.RenderRequest;
import simpleray.scene.FreeView;
import simpleray.scene.Orbit;
import simpleray.scene.SceneSettings;

/** A camera that goes once round what it looks at, at its own height, to its right: a film of any scene. <em>Constant.</em> */
public final class Turntable {
    /** The number of frames, unless asked for. */
    public static final int USUAL_FRAMES = 120;
    private static final double FULL_TURN = 360;

    private final SceneSettings asked;
    private final SceneSettings first;
    private final int frames;

    /**
     * Puts a camera on its way.
     *
     * @param scene the scene's own settings
     * @param request what wins over them; not to be changed
     * @param frames the number of frames, 1 or more
     * @throws IllegalArgumentException if the camera has a value that is out of its range
     */
    public Turntable(SceneSettings scene, RenderRequest request, int frames) {
        asked = request.settings();
        first = FreeView.alone(scene.under(asked));
        this.frames = frames;
    }

    /**
     * Returns the camera of a frame.
     *
     * @param frame its number, from 0
     * @return settings with the camera alone: at frame 0 the scene's own, or the free camera of the same view
     */
    public SceneSettings camera(int frame) {
        return frame == 0 ? first : Orbit.of(first).turned(FULL_TURN * frame / frames, 0).settings();
    }

    /**
     * Returns what is asked for at a frame.
     *
     * @param frame its number, from 0
     * @return the settings, with that frame's camera
     */
    public SceneSettings settings(int frame) {
        SceneSettings all = new SceneSettings().under(asked);
        all.setCamera(camera(frame));
        return all;
    }
}
