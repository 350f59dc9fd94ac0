package simpleray.ui.editor;

import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.swing.Action;
import javax.swing.JComponent;
import simpleray.io.OutputTarget;
import simpleray.text.Diagnostic;
import simpleray.ui.file.MeshCopies;
import simpleray.ui.file.MeshNames;
import simpleray.ui.file.Samples;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.widget.KeyBindings;

/**
 * The text of the window's scene between its file and the editor: reads it, renders it, writes it, and sees to it that nothing is lost
 * where the two differ. For the event thread.
 */
public final class SceneDocument {
    private static final String CONFLICT = "conflict";
    private static final String TEXT = "text";

    private final EditorContext window;
    private final SceneDisk disk;
    private SceneSource source = SceneSource.NONE;
    private SceneEditor editor;                               // null until it is asked for
    private boolean shown;
    private SceneText saved;                                  // as the file has it; null until it was read
    private byte[] bytes;                                     // the file's; null if there is none
    private SceneDisk.Answer other;                           // the bytes that another program wrote while there are unsaved changes
    private boolean changed;
    private SceneSource own;                                  // of the text that was rendered without saving it
    private String ownText;

    /**
     * Creates a document without a scene.
     *
     * @param window the window
     */
    public SceneDocument(EditorContext window) {
        this.window = window;
        disk = new SceneDisk(window.workers().finishing("simpleray-editing"));
    }

    /**
     * Takes another scene, and drops the text of the one before.
     *
     * @param opened the scene
     */
    public void open(SceneSource opened) {
        source = opened;
        saved = null;
        bytes = null;
        resolve();
        if (editor != null) {
            editor.begin("");
            editor.area().setEnabled(false);
        }
        if (shown && source != SceneSource.NONE) {
            read(() -> { });
        }
        refresh();
    }

    /** {@return whether the text is shown} */
    boolean isShown() {
        return shown;
    }

    /** {@return whether there is something that the file does not hold} */
    public boolean isChanged() {
        return changed;
    }

    /** {@return the editor; null until it is asked for} */
    public SceneEditor editor() {
        return editor;
    }

    /** Shows the text or hides it; its changes stay. */
    void toggle() {
        if (shown) {
            shown = false;
            window.banner().hide(TEXT);
            window.showBeside(null);
            window.picture().requestFocusInWindow();
        } else {
            show(() -> editor.area().requestFocusInWindow());
        }
    }

    /** Shows the text, and then does something with it, unless it cannot be had. */
    private void show(Runnable then) {
        if (source == SceneSource.NONE) {
            return;
        }
        make();
        if (!shown) {
            shown = true;
            window.showBeside(editor);
        }
        if (saved == null) {
            read(then);
        } else {
            then.run();
        }
    }

    private void make() {
        if (editor == null) {
            editor = new SceneEditor(this::refresh);
            editor.area().setEnabled(false);
            KeyBindings.bind(editor.area(), JComponent.WHEN_FOCUSED, "control S", this::save);
        }
    }

    /** Begins a new scene, and shows its text. */
    void create() {
        leave(() -> {
            window.open(Samples.template());
            show(() -> editor.area().requestFocusInWindow());
        });
    }

    private void read(Runnable then) {
        SceneSource asked = source;
        disk.read(asked, answer -> {
            if (source != asked) {
                return;
            }
            if (answer.failure() != null || answer.bytes() == null && asked.path() == null) {
                window.banner().show(TEXT, answer.failure() != null ? answer.failure() : "This scene has no text");
                return;
            }
            if (saved == null) {
                take(answer);
                editor.begin(saved.text());
                editor.area().setEnabled(true);
                refresh();
            }
            markProblems(window.picture().job());
            then.run();
        });
    }

    private void take(SceneDisk.Answer answer) {
        bytes = answer.bytes();
        saved = SceneText.of(bytes == null ? new byte[0] : bytes);
        resolve();
    }

    /** Renders the scene and updates the text after its file, or one of its meshes, has changed. */
    public void fileChanged() {
        if (!changed) {
            window.reload(source);
        }
        if (saved == null) {
            return;
        }
        SceneSource asked = source;
        disk.read(asked, answer -> {
            if (source != asked || saved == null) {
                return;
            }
            if (answer.failure() != null || answer.bytes() == null) {
                window.say(answer.failure() == null ? "The text is the last one read" : answer.failure());
            } else if (Arrays.equals(answer.bytes(), bytes)) {
                resolve();
                if (changed) {                                // then it was a mesh
                    window.reload(window.picture().source());
                }
            } else if (changed && !editor.holds(SceneText.of(answer.bytes()).text())) {
                conflict(answer);
            } else {
                take(answer);
                editor.area().replaceAll(saved.text());
                refresh();
                markProblems(window.picture().job());
            }
        });
    }

    /** Asks which text is to stay: the one in the editor or the file's. */
    private void conflict(SceneDisk.Answer answer) {
        other = answer;
        Action reload = KeyBindings.action("Reload", null, () -> {
            take(other);
            editor.area().replaceAll(saved.text());           // can be undone
            refresh();
            window.reload(source);
        });
        reload.putValue(Action.MNEMONIC_KEY, (int) 'L');
        reload.putValue(Action.SHORT_DESCRIPTION, "Take the file's text; Undo brings yours back");
        Action keep = KeyBindings.action("Keep Mine", null, () -> {
            take(other);
            refresh();
            editor.area().requestFocusInWindow();
        });
        keep.putValue(Action.MNEMONIC_KEY, (int) 'K');
        keep.putValue(Action.SHORT_DESCRIPTION, "Go on with the text in the editor; Save Scene then writes it over the file's");
        window.banner().show(CONFLICT, name() + " was changed by another program, and has unsaved changes here", reload, keep);
    }

    private void resolve() {
        other = null;
        window.banner().hide(CONFLICT);
        window.banner().hide(TEXT);
    }

    /** Renders the text as it is, without saving it. */
    void render() {
        if (saved == null) {
            window.picture().reload();
            return;
        }
        ownText = editor.text();
        byte[] text = ownText.getBytes(StandardCharsets.UTF_8);
        own = source.edited(text);
        render(own);
    }

    private void render(SceneSource other) {
        window.picture().setSource(other);
        window.picture().reload();
    }

    /** {@return the text as it is in the editor; null if it was not read} */
    public String text() {
        return saved == null ? null : editor.text();
    }

    /**
     * Takes a text that this program has made of the one in the editor; saves it if that one was saved.
     *
     * @param text the text
     */
    public void replace(String text) {
        boolean clean = !changed;
        editor.area().replaceAll(text);
        if (clean && source.path() != null) {
            save();
        } else {
            render();
        }
    }

    /** Writes the text into the scene's file. */
    void save() {
        save(() -> { });
    }

    /** Writes the text, and does something when it is written. */
    private void save(Runnable then) {
        if (saved == null) {
            return;
        }
        if (source.path() == null) {
            saveAs(then);
            return;
        }
        SceneSource asked = source;
        String text = editor.text();
        SceneText before = saved;
        disk.write(source.path(), false, bytes, () -> before.bytes(text), window::wroteScene, answer -> {
            if (source != asked) {
                return;
            }
            if (answer.other()) {
                conflict(answer);
                window.say(name() + " was not saved");
            } else if (answer.failure() != null) {
                SceneDialogs.failed(window.frame(), source.path(), answer.failure());
            } else {
                take(answer);
                refresh();
                if (window.picture().source() == own && text.equals(ownText)) {
                    window.picture().setSource(source);
                    window.saved(own, source);
                    window.say("Saved " + source.path() + answer.note());
                } else {
                    render(source);
                }
                then.run();
            }
        });
    }

    /** Asks where to write the text, takes the files that it names along, and goes on with the file that is written. */
    void saveAs() {
        make();
        if (saved == null) {
            read(() -> saveAs(() -> { }));
        } else {
            saveAs(() -> { });
        }
    }

    private void saveAs(Runnable then) {
        Path home = source.home() == null ? Path.of("untitled.scene") : source.home();
        Path path = SceneDialogs.target(window.frame(), home);
        if (path == null) {
            return;
        }
        RenderJob job = window.picture().job();
        if (source.path() != null && OutputTarget.isSame(path, source.path())) {
            save(then);
            return;
        }
        if (job != null && job.reads(path)) {
            SceneDialogs.failed(window.frame(), path, RenderJob.READ);
            return;
        }
        String text = editor.text();
        SceneText before = saved;
        SceneSource asked = source;
        disk.write(path, true, null, () -> {
            byte[] written = before.bytes(text);
            MeshCopies.copy(written, home, path);
            return written;
        }, () -> { }, answer -> {
            if (answer.failure() != null) {
                SceneDialogs.failed(window.frame(), path, answer.failure());
            } else if (source == asked) {
                changed = false;
                window.open(SceneSource.file(path, source.reach()));
                window.say("Saved " + path + answer.note());
                then.run();
            }
        });
    }

    /**
     * Does something that would lose what is not saved, after that was saved or may be lost; does nothing if the user cancels.
     *
     * @param then what to do
     */
    public void leave(Runnable then) {
        if (!changed) {
            then.run();
            return;
        }
        int answer = SceneDialogs.unsaved(window.frame(), name());
        if (answer == SceneDialogs.SAVE) {
            save(then);
        } else if (answer == SceneDialogs.DISCARD) {
            forget();
            then.run();
        }
    }

    /** Gives up the changes that are not saved. */
    void forget() {
        changed = false;
    }

    /** Shows the text and the line for finding something in it. */
    void find() {
        show(() -> editor.find());
    }

    /**
     * Marks the problems that a rendering found, if its text is the one in the editor.
     *
     * @param job the rendering
     */
    public void markProblems(RenderJob job) {
        if (saved == null || job == null || job.state() == RenderJob.State.READING) {
            return;
        }
        if (job.source() == own ? editor.holds(ownText) : job.source() == source && !changed) {
            String name = source.name();
            editor.mark(job.snapshot().findings().places().stream().filter(problem -> problem.file().equals(name)).toList());
        }
    }

    /**
     * Shows the place of a problem; that of one in a mesh is where the scene names the mesh.
     *
     * @param problem the problem
     */
    public void goTo(Diagnostic problem) {
        show(() -> {
            if (problem.file().equals(source.name())) {
                editor.goTo(problem.line(), problem.column());
                return;
            }
            window.say("The problem is in " + problem.file() + ", line " + problem.line() + ", column " + problem.column());
            int named = source.home() == null ? -1 : MeshNames.placeOf(problem.file(), editor.text(), source.home());
            if (named >= 0) {
                editor.area().setCaretPosition(named);
                editor.area().requestFocusInWindow();
            }
        });
    }

    /** {@return the problems that are marked in the text} */
    public List<String> marked() {
        return editor == null ? List.of() : editor.area().marked();
    }

    private String name() {
        return new File(source.name()).getName();
    }

    private void refresh() {
        changed = saved != null && !editor.holds(saved.text());
        window.refreshTitle();
    }
}
