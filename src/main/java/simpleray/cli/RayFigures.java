package simpleray.cli;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import simpleray.image.Picture;
import simpleray.rays.OutsideView;
import simpleray.rays.RayDrawing;
import simpleray.rays.RaySegment;
import simpleray.rays.RaySegment.Kind;
import simpleray.render.Explainer;
import simpleray.render.PixelStory;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.Camera;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.RayTree;
import simpleray.scene.RayTree.Area;
import simpleray.scene.RayTree.Contribution;
import simpleray.scene.RayTree.Lamp;
import simpleray.scene.RayTree.Verdict;
import simpleray.scene.Scene;

/** The thesis's figures 1, 2, 6 and 9 of a scene: the rays of one of its pixels. */
final class RayFigures {
    /** Pixels are looked at on a grid of this many columns and rows. */
    private static final int GRID = 11;
    private static final int SAMPLES = 2;
    private static final Set<Kind> BASIC = EnumSet.of(Kind.PRIMARY, Kind.ARRIVING, Kind.STOPPED);

    private RayFigures() {
    }

    /** {@return four pictures of the request's size} */
    @SuppressWarnings("ReferenceEquality")                    // the very ray, not one like it
    static List<Picture> of(Scene scene, RenderRequest request) {
        Camera inside = scene.settings.newCamera();
        PixelStory story = pixel(request.with(Stage.FINAL).renderer(scene).explainer());
        List<RaySegment> all = RaySegment.of(story, scene);
        List<RaySegment> first = all.stream().filter(segment -> segment.ray() == all.get(0).ray()).toList();
        Pose outside = OutsideView.pose(all, inside, inside.width(), inside.height());
        OutsideView whole = view(scene, inside, all, outside);
        List<Picture> pictures = new ArrayList<>();
        pictures.add(new RayDrawing(whole, inside, first, BASIC).picture(story.x(), story.y()));
        pictures.add(new RayDrawing(whole, inside, all, EnumSet.allOf(Kind.class)).picture(story.x(), story.y()));
        for (boolean specular : new boolean[] {false, true}) {
            List<RaySegment> vectors = RaySegment.lighting(all, specular);
            Pose pose = vectors == all ? outside : OutsideView.across(vectors);
            OutsideView near = view(scene, inside, all, pose);
            pictures.add(new RayDrawing(near, inside, vectors, EnumSet.allOf(Kind.class)).picture(story.x(), story.y()));
        }
        return pictures;
    }

    private static OutsideView view(Scene scene, Camera inside, List<RaySegment> all, Pose pose) {
        return OutsideView.of(scene, all.get(0).from(), pose, inside.width(), inside.height(), Stage.FINAL, SAMPLES);
    }

    /** {@return the pixel that shows most: one whose first hit a light reaches and that has a mirror or refracted ray; near the middle} */
    private static PixelStory pixel(Explainer explainer) {
        int bestX = 0;
        int bestY = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int j = 0; j < GRID; j++) {
            for (int i = 0; i < GRID; i++) {
                int x = (2 * i + 1) * explainer.width() / (2 * GRID);
                int y = (2 * j + 1) * explainer.height() / (2 * GRID);
                PixelStory story = explainer.story(x, y);
                double worth = worth(story.samples().get(story.samples().size() / 2).tree())
                    - Math.hypot(i - GRID / 2, j - GRID / 2) / GRID;
                if (worth > most) {
                    most = worth;
                    bestX = x;
                    bestY = y;
                }
            }
        }
        return explainer.story(bestX, bestY, true);
    }

    private static int worth(RayTree tree) {
        RayTree.Hit hit = tree.hit();
        if (hit == null) {
            return 0;
        }
        boolean lit = hit.lamps().stream().anyMatch(RayFigures::arrives);
        return 1 + (lit ? 2 : 0) + (hit.mirror() != null || hit.refracted() != null ? 2 : 0);
    }

    private static boolean arrives(Contribution light) {
        return light instanceof Area area ? area.whole() + area.dimmed() > 0
            : ((Lamp) light).verdict() == Verdict.REACHES || ((Lamp) light).verdict() == Verdict.DIMMED;
    }
}
