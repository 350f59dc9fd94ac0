package simpleray.ui.film;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Dictionary;
import java.util.Hashtable;
import java.util.Locale;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import javax.swing.AbstractButton;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import javax.swing.Timer;
import simpleray.render.RenderRequest;
import simpleray.scene.Film;
import simpleray.scene.Key;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;
import simpleray.text.ShortestDecimal;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.SimpleRay;
import simpleray.ui.picture.ViewerContext;
import simpleray.ui.widget.KeyBindings;

/**
 * The time line of a film below its picture: a slider over its frames, on which the keys are marked, and what plays it. It is there while
 * the scene has frames. For the event thread.
 */
public final class TimeLine {
    private static final double SECOND = 1e9;
    private static final int TICK = 1000;                     // milliseconds for all frames of a second
    private static final int MAX_TICK = 50;
    /** More marks than a slider has room for are not told apart. */
    private static final int MAX_MARKS = 2000;
    private static final int GAP = 6;

    private final ViewerContext window;
    private final SimpleRay picture;
    private final ExecutorService worker;
    private final JPanel row = new JPanel();
    private final JSlider slider = new JSlider();
    private final JLabel number = new JLabel();
    private final JLabel quality = new JLabel();
    private final Timer clock = new Timer(MAX_TICK, e -> tick());
    private final Action play = KeyBindings.action("Play Film", "P", this::playOrPause);
    private final Action first = KeyBindings.action("First Frame", "alt HOME", () -> seek(0));
    private final Action last = KeyBindings.action("Last Frame", "alt END", () -> seek(Integer.MAX_VALUE));
    private final Action previous = KeyBindings.action("Previous Frame", "alt PAGE_UP", () -> seek(frame() - 1));
    private final Action next = KeyBindings.action("Next Frame", "alt PAGE_DOWN", () -> seek(frame() + 1));
    private final Action loop = KeyBindings.action("Loop Film", "shift P", this::loopChanged);

    private final FilmExport export;

    private Scene scene;                                      // of the film; null without one
    private Film film;
    private SceneSettings settings;                           // of the frames' pictures
    private RenderRequest request;                            // with which they are rendered
    private FilmPlayer player;                                // null before it was played as it is now
    private RenderJob known;                                  // the rendering seen last
    private boolean setting;                                  // the slider, not by its user
    private long begun;                                       // when the frame from which it plays was shown
    private int from;

    /**
     * Creates a time line that is not seen before a film is read.
     *
     * @param window the window
     */
    public TimeLine(ViewerContext window) {
        this.window = window;
        picture = window.picture();
        worker = window.workers().stopping("simpleray-film");
        export = new FilmExport(window);
        decorate(play, FilmIcon.PLAY, "Play the film, from this frame on");
        decorate(first, FilmIcon.FIRST, "Go to the film's first frame");
        decorate(last, FilmIcon.LAST, "Go to the film's last frame");
        decorate(loop, FilmIcon.LOOP, "Begin again behind the last frame");
        loop.putValue(Action.SELECTED_KEY, true);
        slider.setName("frame");
        slider.getAccessibleContext().setAccessibleName("Frame");
        slider.addChangeListener(e -> {
            if (!setting) {
                seek(slider.getValue());
            }
        });
        number.setName("frame number");
        quality.setName("frame quality");
        quality.setToolTipText("How fine the frames are that are ready in time");
        row.setName("time line");
        row.setLayout(new BoxLayout(row, BoxLayout.X_AXIS));
        row.setBorder(BorderFactory.createEmptyBorder(2, GAP, 2, GAP));
        row.add(button(new JButton(first)));
        row.add(button(new JButton(play)));
        row.add(button(new JButton(last)));
        row.add(button(new JToggleButton(loop)));
        row.add(slider);
        row.add(Box.createHorizontalStrut(GAP));
        row.add(number);
        row.add(Box.createHorizontalStrut(GAP));
        row.add(quality);
        row.setVisible(false);
        picture.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                pause();                                      // what is asked for by the mouse is asked of the frame that is seen
            }
        });
        enableActions();
    }

    private static void decorate(Action action, Icon icon, String tip) {
        action.putValue(Action.LARGE_ICON_KEY, icon);
        action.putValue(Action.SHORT_DESCRIPTION, tip);
    }

    /** A button shows its action's sign alone, and leaves the keys to the picture. */
    private static AbstractButton button(AbstractButton button) {
        button.setHideActionText(true);
        button.getAccessibleContext().setAccessibleName((String) button.getAction().getValue(Action.NAME));
        button.setFocusable(false);
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        return button;
    }

    /**
     * {@return a component that shows a picture, and the time line below it while there is a film}
     *
     * @param component the picture
     */
    public JComponent below(JComponent component) {
        JPanel both = new JPanel(new BorderLayout());
        both.setMinimumSize(new Dimension(0, 0));
        both.add(component, BorderLayout.CENTER);
        both.add(row, BorderLayout.SOUTH);
        return both;
    }

    /** {@return a menu that plays the film and goes to its frames} */
    public JMenu menu() {
        JMenu menu = new JMenu("Film");
        menu.setMnemonic(KeyEvent.VK_F);
        menu.add(play);
        menu.add(first);
        menu.add(previous);
        menu.add(next);
        menu.add(last);
        menu.add(new JCheckBoxMenuItem(loop));
        return menu;
    }

    /** {@return what plays the film and pauses it, with a sign for a button} */
    public Action play() {
        return play;
    }

    /** {@return what asks where the film is to be written, and writes it} */
    public Action export() {
        return export.action();
    }

    /** {@return what goes to the first frame, with a sign for a button} */
    public Action first() {
        return first;
    }

    /** {@return what goes to the last frame, with a sign for a button} */
    public Action last() {
        return last;
    }

    /** Forgets the film: another scene comes. */
    public void forget() {
        pause();
        picture.play(null);
        picture.setFrame(0);
        show(null, null);
        export.setFilm(null);
    }

    /**
     * Takes notice of a rendering.
     *
     * @param job the rendering
     */
    @SuppressWarnings("ReferenceEquality")                    // the very scene and request, not ones like them
    public void update(RenderJob job) {
        RenderJob.Snapshot now = job.snapshot();
        if (isPlaying() && job != known) {
            pause(false);                                     // something else is rendered: the film is not what is looked at
        }
        known = job;
        if (now.film() != null && now.settings() != null && (now.film().scene() != scene || job.request() != request)) {
            request = job.request();
            show(now.film().scene(), now.settings());
        }
        export.setFilm(film != null && now.film() != null ? job : null);
        showQuality();
    }

    private void show(Scene other, SceneSettings size) {
        boolean another = other != scene;
        if (another) {
            stopPlaying();
        }
        player = null;
        settings = size;
        scene = other;
        boolean moves = scene != null && scene.settings.frames != null;
        film = moves ? scene.film() : null;
        if (film != null) {
            setting = true;
            slider.setMaximum(film.frames() - 1);
            setting = false;
            mark();
            fix(number, text(film.frames() - 1));
            fix(quality, quality(1));
            showFrame(Math.min(picture.frame(), film.frames() - 1));
        }
        if (row.isVisible() != moves) {
            row.setVisible(moves);
            row.getParent().revalidate();
        }
        enableActions();
        if (another) {
            picture.play(null);
        }
    }

    /** Gives a label the width of its longest text, so that the slider beside it stays where it is. */
    private static void fix(JLabel label, String longest) {
        label.setPreferredSize(null);
        label.setText(longest);
        label.setPreferredSize(label.getPreferredSize());
        label.setMinimumSize(label.getPreferredSize());
        label.setMaximumSize(label.getPreferredSize());
        label.setText("");
    }

    private static String quality(int divisor) {
        return "1/" + divisor + " size";
    }

    private void enableActions() {
        for (Action action : new Action[] {play, first, previous, next, last, loop}) {
            action.setEnabled(film != null);
        }
    }

    /** Marks the frames that have keys; those of a key between two frames is the nearest. */
    @SuppressWarnings("JdkObsolete")                          // JSlider wants a Hashtable
    private void mark() {
        Dictionary<Integer, JComponent> marks = new Hashtable<>();
        TreeMap<String, Integer> counts = new TreeMap<>();
        if (scene.settings.keys != null) {
            for (Key key : scene.settings.keys) {
                counts.merge(key.thing().toString(), 1, Integer::sum);
                if (marks.size() < MAX_MARKS) {
                    marks.put((int) Math.rint(key.frame()), new JLabel(FilmIcon.KEY));
                }
            }
        }
        slider.setLabelTable(marks.isEmpty() ? null : marks);
        slider.setPaintLabels(!marks.isEmpty());
        StringBuilder tip = new StringBuilder();
        counts.forEach((thing, count) ->
            tip.append(tip.length() == 0 ? "Keys: " : ", ").append(thing).append(" (").append(count).append(')'));
        slider.setToolTipText(tip.length() == 0 ? "No keys" : tip.toString());
    }

    private String text(int frame) {
        return "Frame " + frame + " of 0\u2013" + (film.frames() - 1);
    }

    private int frame() {
        return slider.getValue();
    }

    private void showFrame(int frame) {
        setting = true;
        slider.setValue(frame);
        setting = false;
        number.setText(text(frame));
        number.setToolTipText(String.format(Locale.ROOT, "%.2f of %.2f s, at %s frames a second", frame / film.rate(),
            film.frames() / film.rate(), ShortestDecimal.of(film.rate())));
    }

    private void showQuality() {
        FrameCache.Kept kept = player == null || !picture.isPlayed() ? null : player.cache().get(frame());
        quality.setText(kept == null || kept.divisor() == 1 ? "" : quality(kept.divisor()));
    }

    /** Goes to a frame, or to the nearest that there is. */
    private void seek(int wanted) {
        if (film == null) {
            return;
        }
        int frame = Math.max(0, Math.min(film.frames() - 1, wanted));
        showFrame(frame);
        if (!isPlaying() && frame == picture.frame()) {
            return;                                           // a slider that is let go of
        }
        stopPlaying();
        FrameCache.Kept kept = player == null ? null : player.cache().get(frame);
        picture.play(kept == null ? null : kept.image());
        stopAt(frame);
    }

    /** Has a frame rendered as a picture of its own. */
    private void stopAt(int frame) {
        if (picture.isPlayed()) {
            picture.endPlay(request);
        }
        picture.setFrame(frame);
        picture.restart();
        showQuality();
    }

    private void playOrPause() {
        if (isPlaying()) {
            pause();
        } else if (film != null && picture.source() != SceneSource.NONE) {
            start();
        }
    }

    private boolean isPlaying() {
        return player != null && player.isPlaying();
    }

    private void start() {
        if (player == null) {
            player = new FilmPlayer(worker, scene, request, Setting.RESOLUTION.in(settings), this::failed);
        }
        picture.stop();
        from = frame() == film.frames() - 1 ? 0 : frame();
        begun = System.nanoTime();
        player.play(from, isLoop());
        clock.setDelay((int) Math.max(1, Math.min(MAX_TICK, TICK / film.rate() / 2)));
        clock.start();
        play.putValue(Action.NAME, "Pause Film");
        play.putValue(Action.LARGE_ICON_KEY, FilmIcon.PAUSE);
    }

    private boolean isLoop() {
        return Boolean.TRUE.equals(loop.getValue(Action.SELECTED_KEY));
    }

    private void loopChanged() {
        if (player != null) {
            player.setLoop(isLoop());
        }
    }

    /** Shows the frame that it is time for, if it is there. */
    private void tick() {
        long passed = (long) ((System.nanoTime() - begun) / SECOND * film.rate());
        long frame = from + passed;
        if (frame >= film.frames() && !isLoop()) {
            seek(film.frames() - 1);
            return;
        }
        int wanted = (int) (frame % film.frames());
        player.shows(wanted);
        FrameCache.Kept kept = player.cache().get(wanted);
        if (kept != null) {
            picture.play(kept.image());
            picture.setFrame(wanted);
            showFrame(wanted);
            showQuality();
        }
    }

    private void pause() {
        pause(true);
    }

    private void pause(boolean render) {
        if (isPlaying()) {
            stopPlaying();
            if (render) {
                stopAt(frame());
            } else {
                picture.endPlay(request);
            }
        }
    }

    private void stopPlaying() {
        clock.stop();
        if (player != null) {
            player.pause();
        }
        play.putValue(Action.NAME, "Play Film");
        play.putValue(Action.LARGE_ICON_KEY, FilmIcon.PLAY);
    }

    private void failed(String why) {
        pause();
        window.say(why);
    }
}
