package simpleray.ui.editor;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.Action;
import javax.swing.JComponent;
import simpleray.io.OutputTarget;
import simpleray.scene.Reach;
import simpleray.scene.SceneSettings;
import simpleray.scene.ViewLines;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;
import simpleray.text.SourceValue;
import simpleray.ui.file.MeshCopies;
import simpleray.ui.file.MeshNames;
import simpleray.ui.file.Samples;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.ObjectOutline;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.SceneReport;
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
    private SceneDisk.Answer copied;                          // what was written into the file that is opened next; null for nothing
    private boolean gone;                                     // the file: the text is nowhere else
    private boolean lost;                                     // the text: the file was deleted, and there is another one of its name
    private SceneSource own;                                  // of the text that was rendered without saving it
    private String ownText;
    private final TextChecker checker;
    private final ObjectOutline outline;
    private Runnable next = () -> { };                        // once the text is checked
    private int pointed;                                      // the object under the mouse in the picture; 0 for none
    private boolean renders = true;                           // what is typed, by itself

    /**
     * Creates a document without a scene.
     *
     * @param window the window
     */
    public SceneDocument(EditorContext window) {
        this.window = window;
        disk = new SceneDisk(window.workers().finishing("simpleray-editing"));
        outline = new ObjectOutline(window);
        checker = new TextChecker(window.workers().stopping("simpleray-checking"), this::text, text -> source.edited(text), this::checked);
    }

    /**
     * Takes another scene, and drops the text of the one before, unless that was written into the file.
     *
     * @param opened the scene
     */
    public void open(SceneSource opened) {
        source = opened;
        gone = false;
        next = () -> { };
        if (copied != null) {
            take(copied);
            editor.area().replaceAll(saved.text());           // what was typed can still be undone
            window.showFaults(null);
            refresh();
            return;
        }
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
        window.showFaults(null);
        refresh();
    }

    /** {@return whether the text is shown} */
    boolean isShown() {
        return shown;
    }

    /** {@return whether there is something that the file does not hold} */
    public boolean isChanged() {
        return changed || gone || lost;
    }

    /** {@return the editor; null until it is asked for} */
    public SceneEditor editor() {
        return editor;
    }

    /** Shows the text, in front, or hides it; its changes stay. */
    void toggle() {
        if (shown && window.sides().raise(editor)) {
            editor.area().requestFocusInWindow();
        } else if (shown) {
            shown = false;
            window.banner().hide(TEXT);
            window.tellValue(" ");
            outline.show(0);
            window.sides().showText(null);
            window.picture().requestFocusInWindow();
        } else {
            show(() -> editor.area().requestFocusInWindow());
        }
    }

    /**
     * Shows the text, and then does something with it, unless it cannot be had.
     *
     * @param then what to do
     */
    public void show(Runnable then) {
        if (source == SceneSource.NONE) {
            return;
        }
        make();
        if (!shown) {
            shown = true;
            window.sides().showText(editor);
        } else {
            window.sides().raise(editor);
        }
        if (saved == null) {
            read(then);
        } else {
            then.run();
        }
    }

    private void make() {
        if (editor == null) {
            editor = new SceneEditor(this::textChanged, this::valueChanged);
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
            byte[] text = answer.bytes() == null && answer.failure() == null ? rendered() : answer.bytes();
            if (text == null) {
                window.banner().show(TEXT, answer.failure() != null ? answer.failure()
                    : asked.path() == null ? "This scene has no text" : name() + " is not there, and its text is not known");
                return;
            }
            if (saved == null) {
                take(answer, text);
                gone = answer.bytes() == null;
                editor.begin(saved.text());
                editor.area().setEnabled(true);
                refresh();
            }
            markProblems(window.picture().job());
            then.run();
        });
    }

    /** {@return the text of the picture's scene as it was read from a file that is gone; null if it was not kept} */
    private byte[] rendered() {
        RenderJob job = window.picture().job();
        return job == null || source.path() == null ? null : job.bytesOf(source.path());
    }

    /** Tells what the value at the caret is, and lights up the object at hand: the one under the mouse, or else at the caret. */
    private void valueChanged() {
        window.tellValue(valueLine());
        light();
    }

    /**
     * Takes notice of the object under the mouse in the picture.
     *
     * @param number its number, from 1; 0 for none
     */
    public void pointed(int number) {
        if (pointed != number) {
            pointed = number;
            light();
        }
    }

    private void light() {
        if (shown) {
            SourceValue.Thing thing = pointed > 0 ? editor.area().values().object(pointed) : editor.area().thing();
            editor.area().light(thing);
            outline.show(thing == null || !thing.what().equals("object") ? 0 : thing.number());
        }
    }

    /** {@return what lights up objects in the picture} */
    public ObjectOutline outline() {
        return outline;
    }

    private void textChanged() {
        refresh();
        if (editor.area().numbers().isChanging()) {
            checker.now();                                    // the picture follows the mouse
        } else {
            checker.changed();
        }
    }

    /** Takes what was found in the text, unless it has changed meanwhile: then it is read again. Renders it, if it is right. */
    private void checked(TextChecker.Check check) {
        if (saved == null || !editor.holds(check.text())) {
            return;
        }
        editor.setValues(new ValueTable(check.text(), check.values().all()));
        boolean rendered = isRendered(check.text());
        if (changed && check.failure() != null) {
            fault(SceneReport.of(check.failure(), source.name()));
        } else if (rendered || renders) {
            window.showFaults(null);
            if (!rendered) {
                own = check.source();
                ownText = check.text();
                window.picture().setSource(isChanged() ? own : source);
                window.picture().restart();
            }
        } else {
            fault(SceneReport.of(check.file() == null ? List.of() : check.file().warnings()));
        }
        Runnable task = next;
        next = () -> { };
        task.run();
    }

    private void fault(SceneReport report) {
        window.showFaults(report);
        mark(report);
    }

    private void mark(SceneReport report) {
        String name = source.name();
        editor.mark(report.places().stream().filter(problem -> problem.file().equals(name)).toList());
    }

    private boolean isRendered(String text) {
        SceneSource now = window.picture().source();
        return now == own ? text.equals(ownText) : now == source && !changed;
    }

    /** {@return what the value at the caret is; a blank for none} */
    public String valueLine() {
        return shown ? editor.valueLine() : " ";
    }

    /** {@return the settings of the picture; null if there is none} */
    SceneSettings settings() {
        RenderJob job = window.picture().job();
        return job == null ? null : job.snapshot().settings();
    }

    /** Shows the text, and then does something with it and its values. */
    private void withValues(Runnable task) {
        show(() -> {
            next = task;
            checker.now();
        });
    }

    /** Adds the line of an object or light to the text, which is shown, behind those that are there. */
    void insert(String what, String line) {
        withValues(() -> {
            if (!editor.insert(what, line)) {
                window.say("The text has no number of " + what + "s that could be raised: see its problems");
            }
        });
    }

    /** Lets the user pick the colour at the caret. */
    void chooseColour() {
        withValues(() -> {
            if (!editor.area().colours().choose(editor.area().values().at(editor.area().getCaretPosition()))) {
                window.say("There is no colour at the caret: put it on a red, green or blue");
            }
        });
    }

    /** Renders what is typed after a pause, or only on request. */
    void setRenders(boolean byItself) {
        renders = byItself;
        if (saved != null) {
            checker.now();
        }
    }

    private void take(SceneDisk.Answer answer) {
        take(answer, answer.bytes());
    }

    private void take(SceneDisk.Answer answer, byte[] text) {
        bytes = answer.bytes();
        saved = SceneText.of(text);
        resolve();
    }

    /** Takes notice that the file was deleted: what is in the editor is on no disk any more. */
    public void fileGone() {
        gone = saved != null;
        refresh();
    }

    /** Renders the scene and updates the text after its file, or one of its meshes, has changed. */
    public void fileChanged() {
        lost = gone || lost;
        if (!changed && !lost) {
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
            gone = answer.failure() == null && answer.bytes() == null;
            refresh();
            if (answer.failure() != null || gone) {
                window.say(gone ? "The text is the last one read" : answer.failure());
            } else if (Arrays.equals(answer.bytes(), bytes)) {
                boolean again = changed || lost;              // a mesh, or the file is there again
                resolve();
                if (again) {
                    window.reload(changed ? window.picture().source() : source);
                }
                refresh();
            } else if (isChanged() && !editor.holds(SceneText.of(answer.bytes()).text())) {
                conflict(answer);
            } else {
                boolean again = lost;
                take(answer);
                editor.area().replaceAll(saved.text());
                refresh();
                if (again) {
                    window.reload(source);
                }
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
            if (gone) {                                       // deleted since it was changed
                render();
            } else {
                window.reload(source);
            }
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
        lost = false;
        window.banner().hide(CONFLICT);
        window.banner().hide(TEXT);
    }

    /** Renders the text as it is, without saving it. */
    void render() {
        if (saved == null) {
            window.picture().reload();
            return;
        }
        window.showFaults(null);
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
     * @param done what was done, for a message that goes on to say where
     */
    public void replace(String text, String done) {
        boolean clean = !changed;
        editor.area().setCaretPosition(editor.area().replaceAll(text));   // which brings it into sight
        if (clean && source.path() != null) {
            save(done + " in ", () -> { });
        } else {
            render();
            window.say(done + " in the text, which is not saved yet");
        }
    }

    /** Writes the text into the scene's file. */
    void save() {
        save(() -> { });
    }

    private void save(Runnable then) {
        save("Saved ", then);
    }

    /** Writes the text, and does something when it is written; a message says what was done, and then names the file. */
    private void save(String done, Runnable then) {
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
                gone = false;
                refresh();
                if (window.picture().source() == own && text.equals(ownText)) {
                    window.picture().setSource(source);
                    window.saved(own, source);
                } else {
                    render(source);
                }
                window.say(done + source.path() + answer.note());   // the rendering that saving begins leaves it there
                then.run();
            }
        });
    }

    /**
     * Asks where to write the text, takes the view on the screen and the files that it names along, and goes on with the file that is
     * written.
     */
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
            save(window.camera().unsaved() == null ? then : window.camera()::save);
            return;
        }
        if (job != null && job.reads(path)) {
            SceneDialogs.failed(window.frame(), path, RenderJob.READ);
            return;
        }
        String text = editor.text();
        SceneText before = saved;
        SceneSource asked = source;
        boolean other = window.camera().isOther();
        ViewLines.Change view = window.camera().unsaved();
        AtomicBoolean seen = new AtomicBoolean();             // the view is in the file
        disk.write(path, true, null, () -> {
            byte[] own = before.bytes(text);
            byte[] written = view == null ? own : withView(own, view, home, asked.reach());
            seen.set(view != null && written != null);
            MeshCopies.copy(seen.get() ? written : own, home, path);
            return seen.get() ? written : own;
        }, () -> { }, answer -> {
            if (answer.failure() != null) {
                SceneDialogs.failed(window.frame(), path, answer.failure());
            } else if (source == asked) {
                forget();
                if (seen.get()) {
                    window.camera().release();
                }
                copied = answer;
                window.open(SceneSource.file(path, source.reach()));
                copied = null;
                window.say("Saved " + path + (seen.get() ? " with the view on the screen" : !other ? ""
                    : view == null ? " without the moved view: its camera has keys" : " without the moved view: the text has errors")
                    + answer.note());
                then.run();
            }
        });
    }

    /** {@return a text with a view in it; null if it is no scene} */
    private static byte[] withView(byte[] text, ViewLines.Change view, Path home, Reach reach) throws IOException {
        try {
            return view.apply(text, home, reach);
        } catch (SceneFormatException e) {
            return null;
        }
    }

    /**
     * Does something that would lose what is not saved, after that was saved or may be lost; does nothing if the user cancels.
     *
     * @param then what to do
     */
    public void leave(Runnable then) {
        if (!isChanged()) {
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
    public void forget() {
        changed = false;
        gone = false;
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
            mark(job.snapshot().findings());
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

    /**
     * Shows a line of the text.
     *
     * @param line the line, from 1
     */
    public void goTo(int line) {
        show(() -> editor.goTo(line, 1));
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
