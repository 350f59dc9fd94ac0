package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import simpleray.Project;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.Reach;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.text.Diagnostic;
import simpleray.ui.file.FileSource;

/** The warnings about a scene come with its first picture that is whole. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RenderJobWarningsTest {
    private static final String WARNING = "light 2 (line 55) lights nothing that is seen: object 4 (plane, line 19) is in the way";

    private static RenderRequest request(int side) {
        SceneSettings settings = new SceneSettings();
        settings.resolution = new Resolution(side, side);
        return new RenderRequest(settings, Stage.FINAL, false, 1);
    }

    private static RenderJob first(int side) {
        return new RenderJob(new FileSource(Project.scene("thesis"), Reach.FOLDER), request(side), null, false);
    }

    private static SceneReport findings(RenderJob job) throws InterruptedException {
        job.start();
        job.await();
        return job.snapshot().findings();
    }

    @Test
    void theCameraMovesBeforeTheFirstPictureIsWhole() throws InterruptedException {
        RenderJob first = first(4000);
        first.start();
        while (!first.snapshot().hasScene()) {
            Thread.sleep(1);
        }
        RenderJob second = new RenderJob(first, SceneReport.NONE, request(8), null, false);

        assertThat(findings(second).places()).extracting(Diagnostic::message).containsExactly(WARNING);
        assertThat(first.state()).isEqualTo(RenderJob.State.CANCELLED);
        assertThat(first.snapshot().findings().isEmpty()).isTrue();
        RenderJob third = new RenderJob(second, SceneReport.NONE, request(8), null, false);
        assertThat(findings(third)).as("looked for only once").isSameAs(second.snapshot().findings());
    }

    /** The file is no scene any more, and the old one is shown on: what is said is about the file. */
    @Test
    void whatIsWrongWithTheFileSinceStays() throws InterruptedException {
        RenderJob first = first(8);
        assertThat(findings(first).places()).hasSize(1);
        SceneReport known = new SceneReport("no scene", first.snapshot().findings().places());
        RenderJob second = new RenderJob(first, known, request(8), null, false);

        assertThat(findings(second)).isSameAs(known);
        assertThat(findings(new RenderJob(second, SceneReport.NONE, request(8), null, false))).isSameAs(known);
    }
}
