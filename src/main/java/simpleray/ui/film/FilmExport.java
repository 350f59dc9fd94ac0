package simpleray.ui.film;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.regex.Pattern;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.filechooser.FileFilter;
import javax.swing.filechooser.FileNameExtensionFilter;
import javax.swing.plaf.basic.BasicFileChooserUI;
import simpleray.film.FilmException;
import simpleray.film.FilmOutput;
import simpleray.film.FilmRenderer;
import simpleray.render.OutOfMemory;
import simpleray.render.Progress;
import simpleray.render.RenderListener;
import simpleray.render.RenderRequest;
import simpleray.scene.SceneFile;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.ViewerContext;
import simpleray.ui.widget.KeyBindings;

/** Asks where a film is to be written, has it rendered as {@code simpleray animate} does, and shows how far it is. For the event thread. */
final class FilmExport {
    private static final String TITLE = "Export Film";
    private static final String NOT = "The film was not exported";
    /** The formats that the dialog offers, each by its ending; the first one is that of a name without an ending. */
    private static final List<FileNameExtensionFilter> FORMATS = List.of(new FileNameExtensionFilter("GIF (*.gif)", "gif"),
        new FileNameExtensionFilter("Animated PNG (*.apng)", "apng"), new FileNameExtensionFilter("MP4, by ffmpeg (*.mp4)", "mp4"),
        new FileNameExtensionFilter("WebM, by ffmpeg (*.webm)", "webm"),
        new FileNameExtensionFilter("Numbered pictures (film.%04d.png)", "png"));
    private static final String NUMBER = ".%04d.";
    private static final Pattern ENDING = Pattern.compile("(\\.%\\d*d)?\\.(gif|apng|mp4|webm|png)$", Pattern.CASE_INSENSITIVE);
    private static final int LOOK = 200;                      // milliseconds between two states of the progress
    private static final int WIDTH = 360;
    private static final int GAP = 12;
    private static final int PERCENT = 100;

    private final ViewerContext window;
    private final Executor worker;
    private final Action action = KeyBindings.action("Export Film\u2026", "control shift E", this::ask);
    private RenderJob job;                                    // of the film that is shown; null without one
    private volatile FilmRenderer current;                    // null while none is exported
    private volatile Progress progress;                       // of that; null before there is some
    private volatile String note = "";                        // in what way a file was not written as files usually are

    FilmExport(ViewerContext window) {
        this.window = window;
        worker = window.workers().stopping("simpleray-exporting");
        action.setEnabled(false);
        window.frame().addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent e) {
                cancel();
            }
        });
    }

    /** {@return what asks and exports} */
    Action action() {
        return action;
    }

    /** Sets the rendering that has read the film; null for none. */
    void setFilm(RenderJob other) {
        job = other;
        action.setEnabled(job != null && current == null);
    }

    private void cancel() {
        FilmRenderer running = current;
        if (running != null) {
            running.cancel();
        }
    }

    private void ask() {
        RenderJob asked = job;
        SceneFile film = asked.snapshot().film();
        RenderRequest request = window.picture().request();
        JFileChooser chooser = new JFileChooser();
        chooser.setDialogTitle(TITLE);
        chooser.setAcceptAllFileFilterUsed(true);
        FORMATS.forEach(chooser::addChoosableFileFilter);
        chooser.setFileFilter(FORMATS.get(0));
        chooser.setSelectedFile(suggestion(asked.source()));
        chooser.addPropertyChangeListener(JFileChooser.FILE_FILTER_CHANGED_PROPERTY, e -> follow(chooser));
        while (chooser.showSaveDialog(window.frame()) == JFileChooser.APPROVE_OPTION) {
            try {
                FilmOutput output = FilmOutput.of(named(chooser.getSelectedFile(), chooser.getFileFilter()).getPath());
                FilmRenderer made = new FilmRenderer(film, request, output, FilmRenderer.Plan.ALL);
                FilmRenderer.Kept before = before(asked, output, made);
                if (before != null) {
                    export(made, output, before);
                    return;
                }
            } catch (IllegalArgumentException e) {
                tell(e.getMessage());
            }
        }
    }

    /** Gives the name that stands in a dialog the ending of another format that is chosen. */
    private static void follow(JFileChooser chooser) {
        if (chooser.getUI() instanceof BasicFileChooserUI ui && ui.getFileName() != null && FORMATS.contains(chooser.getFileFilter())) {
            String bare = ENDING.matcher(ui.getFileName()).replaceFirst("");
            if (!bare.isEmpty() && !new File(bare).isAbsolute()) {
                chooser.setSelectedFile(named(new File(chooser.getCurrentDirectory(), bare), chooser.getFileFilter()));
            }
        }
    }

    /** {@return the file; one whose name has no ending gets that of a format, a GIF's if no format is chosen} */
    static File named(File file, FileFilter format) {
        if (file.getName().indexOf('.') >= 0) {
            return file;
        }
        String ending = (format instanceof FileNameExtensionFilter chosen ? chosen : FORMATS.get(0)).getExtensions()[0];
        return new File(file.getPath() + ("png".equals(ending) && file.getName().indexOf('%') < 0 ? NUMBER : ".") + ending);
    }

    /** {@return a file beside the scene} */
    private static File suggestion(SceneSource source) {
        Path path = source.path() == null ? Path.of("film") : source.path();
        String name = path.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return path.toAbsolutePath().resolveSibling((dot > 0 ? name.substring(0, dot) : name) + ".gif").toFile();
    }

    /** {@return what is done with what is there already; null to ask for another name} */
    private FilmRenderer.Kept before(RenderJob asked, FilmOutput output, FilmRenderer film) {
        Path path = Path.of(output.isSingle() ? output.name() : output.frame(0));
        if (asked.reads(path) || !output.isSingle() && film.frames().stream().anyMatch(f -> asked.reads(Path.of(output.frame(f))))) {
            tell(RenderJob.READ);
            return null;
        }
        if (output.hasFolder() || !output.isSingle() && Files.exists(path)) {
            String[] answers = {"Go On", "Begin Anew", "Cancel"};
            int answer = JOptionPane.showOptionDialog(window.frame(), output.place() + " holds frames of an earlier export.", TITLE,
                JOptionPane.DEFAULT_OPTION, JOptionPane.QUESTION_MESSAGE, null, answers, answers[0]);
            return answer == 0 ? FilmRenderer.Kept.RESUMED : answer == 1 ? FilmRenderer.Kept.DISCARDED : null;
        }
        boolean free = !Files.exists(path) || JOptionPane.showConfirmDialog(window.frame(), path.getFileName()
            + " is there already. Replace it?", TITLE, JOptionPane.OK_CANCEL_OPTION, JOptionPane.WARNING_MESSAGE) == JOptionPane.OK_OPTION;
        return free ? FilmRenderer.Kept.REFUSED : null;
    }

    private void export(FilmRenderer film, FilmOutput output, FilmRenderer.Kept before) {
        current = film;
        progress = null;
        note = "";
        action.setEnabled(false);
        JProgressBar bar = new JProgressBar(0, PERCENT);
        JDialog dialog = dialog(output, bar);
        Timer look = new Timer(LOOK, e -> show(bar, film));
        look.start();
        dialog.setVisible(true);
        worker.execute(() -> {
            String failure = failure(film, before);
            SwingUtilities.invokeLater(() -> {
                look.stop();
                dialog.dispose();
                current = null;
                action.setEnabled(job != null);
                ended(film, output, failure);
            });
        });
    }

    private JDialog dialog(FilmOutput output, JProgressBar bar) {
        JDialog dialog = new JDialog(window.frame(), "Exporting " + Path.of(output.name()).getFileName(), false);
        dialog.setDefaultCloseOperation(JDialog.DO_NOTHING_ON_CLOSE);
        JPanel pane = new JPanel(new BorderLayout(GAP, GAP));
        pane.setBorder(BorderFactory.createEmptyBorder(GAP, GAP, GAP, GAP));
        bar.setName("export");
        bar.setStringPainted(true);
        bar.setString("");
        bar.setPreferredSize(new Dimension(WIDTH, bar.getPreferredSize().height));
        JButton cancel = new JButton("Cancel");
        cancel.addActionListener(e -> cancel());
        JPanel row = new JPanel(new FlowLayout(FlowLayout.TRAILING, 0, 0));
        row.add(cancel);
        pane.add(bar, BorderLayout.CENTER);
        pane.add(row, BorderLayout.SOUTH);
        dialog.setContentPane(pane);
        dialog.getRootPane().setDefaultButton(cancel);
        KeyBindings.bind(pane, JPanel.WHEN_IN_FOCUSED_WINDOW, "ESCAPE", this::cancel);
        dialog.pack();
        dialog.setLocationRelativeTo(window.frame());
        return dialog;
    }

    private void show(JProgressBar bar, FilmRenderer film) {
        Progress now = progress;
        if (now != null) {
            bar.setValue(now.percent());
            bar.setString(film.whole() + " of " + film.frames().cardinality() + " frames, "
                + Progress.time(now.left(System.nanoTime())) + " left");
        }
    }

    /** {@return why the film was not made; null if it was, empty if it was cancelled} */
    private String failure(FilmRenderer film, FilmRenderer.Kept before) {
        try {
            film.write(before, new FilmRenderer.Listener() {
                @Override
                public void found(int count) {
                    // the progress shows it
                }

                @Override
                public RenderListener begins(Progress counter) {
                    progress = counter;
                    return y -> counter.rowFinished();
                }

                @Override
                public void note(String text) {
                    note = "; " + text;
                }
            });
            return null;
        } catch (CancellationException e) {
            return "";
        } catch (FilmException e) {
            return film.isCancelled() ? "" : e.getMessage();
        } catch (RuntimeException | Error e) {
            return OutOfMemory.isBehind(e) ? OutOfMemory.MESSAGE : e.toString();
        }
    }

    private void ended(FilmRenderer film, FilmOutput output, String failure) {
        if (failure == null) {
            window.say("Exported " + output.name() + note);
        } else if (failure.isEmpty()) {
            window.say("The export was cancelled" + (output.keepsFrames() && film.whole() > 0 ? "; " + film.whole() + " of "
                + film.frames().cardinality() + " frames are kept: export to the same file to go on" : ""));
        } else if (window.frame().isDisplayable()) {
            tell(failure);
        }
    }

    private void tell(String why) {
        JOptionPane.showMessageDialog(window.frame(), why, NOT, JOptionPane.ERROR_MESSAGE);
    }
}
