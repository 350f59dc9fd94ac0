package simpleray.ui.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneWatcher.News;

/** Files that change on the disk. */
class SceneWatcherTest {
    private final List<News> news = new CopyOnWriteArrayList<>();

    @TempDir
    private Path folder;
    private Path scene;
    private SceneWatcher watcher;

    @BeforeEach
    void writeTheScene() throws IOException {
        scene = Files.writeString(folder.resolve("room.scene"), "1\n4 \"#1.obj\" 0 # \"no.obj\"\n");
    }

    @AfterEach
    void close() throws InterruptedException {
        watcher.close();
        watcher.await();
        Screen.until("its thread ends", () -> OpenWindow.threads().isEmpty());
    }

    @WindowTest
    void aFileThatIsWrittenInPlaceIsTold() throws IOException {
        watch();
        Files.writeString(scene, "2");
        untilTold(News.CHANGED);
    }

    @WindowTest
    void aFileThatTakesItsPlaceIsToldThoughSizeAndTimeAreTheSame() throws IOException {
        FileTime time = Files.getLastModifiedTime(scene);
        watch();
        Path other = Files.writeString(folder.resolve("room.new"), Files.readString(scene).replace('4', '5'));
        Files.setLastModifiedTime(other, time);
        Files.move(other, scene, StandardCopyOption.ATOMIC_MOVE);
        untilTold(News.CHANGED);
    }

    @WindowTest
    void aFileThatIsDeletedAndBackIsTold() throws IOException {
        watch();
        Files.delete(scene);
        untilTold(News.DELETED);
        Files.writeString(scene, "3");
        untilTold(News.DELETED, News.CHANGED);
    }

    @WindowTest
    void aMeshIsTold() throws IOException {
        watch();
        Files.writeString(folder.resolve("#1.obj"), "v 0 0 0");
        untilTold(News.CHANGED);
    }

    @WindowTest
    void aMeshThatTheSceneNamesLaterIsTold() throws IOException {
        watch();
        Files.writeString(scene, "1\n4 \"later.obj\"");
        untilTold(News.CHANGED);
        Files.writeString(folder.resolve("#1.obj"), "no longer named");
        Files.writeString(folder.resolve("no.obj"), "in a comment only");
        Files.writeString(folder.resolve("later.obj"), "v 0 0 0");
        untilTold(News.CHANGED, News.CHANGED);
    }

    @WindowTest
    void anMtlFileIsToldIfTheSceneHasMaterialsOfIt() throws IOException {
        Files.writeString(folder.resolve("#1.obj"), "v 0 0 0\nmtllib my house.mtl a.mtl # materials\n");
        Files.writeString(folder.resolve("a.mtl"), "newmtl a");
        Files.writeString(scene, "1\n4 \"#1.obj\" 0 0 0 1 # no mtl\n");
        watch();
        Files.writeString(folder.resolve("a.mtl"), "newmtl abc");
        Files.writeString(scene, "1\n4 \"#1.obj\" 0 0 0 1\nmtl");
        untilTold(News.CHANGED);
        Files.writeString(folder.resolve("a.mtl"), "newmtl b");
        untilTold(News.CHANGED, News.CHANGED);
        Files.writeString(folder.resolve("my house.mtl"), "newmtl c");
        untilTold(News.CHANGED, News.CHANGED, News.CHANGED);
        Files.writeString(folder.resolve("#1.obj"), "v 0 0 0\nmtllib \\\n b.mtl ../c.mtl\n");
        untilTold(News.CHANGED, News.CHANGED, News.CHANGED, News.CHANGED);
        Files.writeString(folder.resolve("b.mtl"), "newmtl d");
        untilTold(News.CHANGED, News.CHANGED, News.CHANGED, News.CHANGED, News.CHANGED);
    }

    @WindowTest
    void aLinkIsFollowed() throws IOException {
        Path real = Files.writeString(Files.createDirectory(folder.resolve("real")).resolve("a.scene"), "1");
        Files.delete(scene);
        Files.createSymbolicLink(scene, real);
        watch();
        Files.writeString(real, "22");
        untilTold(News.CHANGED);
    }

    @WindowTest
    void aFolderThatIsMovedAwayAndBackIsADeletedScene() throws IOException {
        scene = Files.writeString(Files.createDirectory(folder.resolve("a")).resolve("b.scene"), "1");
        watch();
        Files.move(folder.resolve("a"), folder.resolve("moved"));
        untilTold(News.DELETED);
        Files.move(folder.resolve("moved"), folder.resolve("a"));
        untilTold(News.DELETED, News.CHANGED);
    }

    @WindowTest
    void whatTheProgramWroteItselfIsNoNews() throws IOException {
        watcher = new SceneWatcher(scene, news::add);
        Files.writeString(scene, "its own");
        watcher.wrote();
        watcher.start();
        Files.delete(scene);
        untilTold(News.DELETED);
    }

    @WindowTest
    void aSceneThatIsNotThereYetIsToldWhenItIs() throws IOException {
        Files.delete(scene);
        watch();
        Files.writeString(scene, "1");
        untilTold(News.CHANGED);
    }

    private void watch() {
        watcher = new SceneWatcher(scene, news::add);
        watcher.start();
        Screen.until("all is watched", watcher::isWatching);
    }

    private void untilTold(News... all) {
        Screen.until("the news are " + List.of(all), () -> news.size() >= all.length);
        assertThat(news).containsExactly(all);
    }
}
