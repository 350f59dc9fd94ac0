package simpleray.ui.picture;

import java.awt.event.KeyEvent;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JOptionPane;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;
import simpleray.render.RenderRequest;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;
import simpleray.scene.ViewLines;
import simpleray.ui.file.SceneSource;
import simpleray.ui.widget.KeyBindings;

/** The size of the picture, its samples and its depth, chosen in the Render menu, and written into the scene on request. */
public final class PictureSettings {
    private static final List<Setting<?>> ALL = List.of(Setting.RESOLUTION, Setting.SAMPLES, Setting.DEPTH);
    private static final String TITLE = "Picture";

    private final ViewerContext window;
    private final SimpleRay picture;
    private final Consumer<Runnable> opener;
    private final TextChange edit;
    private final Map<JMenuItem, Choice> choices = new LinkedHashMap<>();

    /** A value of a setting, as the command line has it. */
    private record Choice(Setting<?> setting, String value) {
    }

    /**
     * Creates the items.
     *
     * @param window the window
     * @param opener shows the scene's text, and then runs a task
     * @param text supplies the scene's text as it is edited
     * @param replacement takes the text with other settings in it, and what was done
     */
    public PictureSettings(ViewerContext window, Consumer<Runnable> opener, Supplier<String> text,
                           BiConsumer<String, String> replacement) {
        this.window = window;
        this.opener = opener;
        picture = window.picture();
        edit = new TextChange(window, text, replacement, window.workers().finishing("simpleray-settings"), TITLE);
    }

    /**
     * Adds the items.
     *
     * @param menu the menu, whose items are ticked when it opens
     */
    public void addTo(JMenu menu) {
        JMenu size = choices("Size", KeyEvent.VK_Z, Setting.RESOLUTION, "320x240", "640x480", "800x600", "1280x960", "1920x1080");
        size.add(KeyBindings.action("Other\u2026", null, this::askForSize));
        menu.addSeparator();
        menu.add(size);
        menu.add(choices("Samples", KeyEvent.VK_S, Setting.SAMPLES, "1", "2", "3", "4", "8"));
        menu.add(choices("Recursion Depth", KeyEvent.VK_R, Setting.DEPTH, "0", "1", "2", "5", "10", "30"));
        JMenuItem back = menu.add(KeyBindings.action("As in the Scene", null, () -> set(this::reset)));
        JMenuItem write = menu.add(KeyBindings.action("Write into the Scene", null, () -> opener.accept(this::write)));
        menu.addMenuListener(new MenuListener() {
            @Override
            public void menuSelected(MenuEvent e) {
                choices.forEach((item, choice) -> item.setSelected(choice.value.equals(now(choice.setting))));
                boolean chosen = ALL.stream().anyMatch(setting -> setting.isSet(picture.request().settings()));
                back.setEnabled(chosen);
                write.setEnabled(chosen && picture.source() != SceneSource.NONE);
            }

            @Override
            public void menuDeselected(MenuEvent e) {
                // nothing is held
            }

            @Override
            public void menuCanceled(MenuEvent e) {
                // nothing is held
            }
        });
    }

    private JMenu choices(String name, int mnemonic, Setting<?> setting, String... values) {
        JMenu menu = new JMenu(name);
        menu.setMnemonic(mnemonic);
        for (String value : values) {
            String told = setting == Setting.SAMPLES && !value.equals("1") ? value + " \u00D7 " + value + " a pixel"
                : setting == Setting.SAMPLES ? "1 a pixel" : value.replace("x", " \u00D7 ");
            JMenuItem item = new JRadioButtonMenuItem(KeyBindings.action(told, null, () -> choose(setting, value)));
            choices.put(item, new Choice(setting, value));
            menu.add(item);
        }
        return menu;
    }

    private void choose(Setting<?> setting, String value) {
        if (!value.equals(now(setting))) {                    // else the picture would be the same
            set(settings -> setting.parse(value, settings));
        }
    }

    /** {@return a setting's value in the picture that is asked for, as the command line has it; null if there is none, or no number} */
    private String now(Setting<?> setting) {
        SceneSettings known = picture.job() == null ? null : picture.job().snapshot().settings();
        if (known == null || setting == Setting.SAMPLES && picture.request().adaptive()) {
            return null;
        }
        SceneSettings all = known.under(picture.request().settings());
        return setting == Setting.RESOLUTION
            ? Setting.RESOLUTION.in(all).width() + "x" + Setting.RESOLUTION.in(all).height() : String.valueOf(setting.in(all));
    }

    private void askForSize() {
        Object answer = JOptionPane.showInputDialog(window.frame(), "Width and height in pixels, such as 640x480:", TITLE,
            JOptionPane.PLAIN_MESSAGE, null, null, now(Setting.RESOLUTION));
        if (answer != null) {
            try {
                set(settings -> Setting.RESOLUTION.parse(answer.toString().replaceAll("\\s", ""), settings));
            } catch (IllegalArgumentException e) {
                edit.tell(e.getMessage());
            }
        }
    }

    private void set(Consumer<SceneSettings> change) {
        request(change);
        if (picture.job() != null) {
            picture.showOrRestart();
        }
    }

    private void request(Consumer<SceneSettings> change) {
        RenderRequest old = picture.request();
        SceneSettings settings = new SceneSettings().under(old.settings());
        change.accept(settings);
        boolean adaptive = old.adaptive() && settings.samples == null;
        picture.setRequest(new RenderRequest(settings, old.stage(), adaptive, old.accel(), old.threads(), old.region(), old.band()));
    }

    private void reset(SceneSettings settings) {
        SceneSettings none = new SceneSettings();
        ALL.forEach(setting -> setting.copy(none, settings));
    }

    /** Puts what was chosen here, or on the command line, into the text. */
    private void write() {
        SceneSettings chosen = new SceneSettings();
        ALL.forEach(setting -> setting.copy(picture.request().settings(), chosen));
        if (chosen.lines().isEmpty()) {
            window.say("The scene has these settings already");
            return;
        }
        edit.make((bytes, path, reach) -> ViewLines.putSettings(bytes, path, chosen, reach),
            "Set " + chosen.lines().strip().replace("\n", "; "), () -> request(this::reset));
    }
}
