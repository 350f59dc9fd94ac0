package simpleray.ui;

import java.awt.event.KeyEvent;
import javax.swing.Action;
import javax.swing.ButtonGroup;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JRadioButtonMenuItem;
import simpleray.render.Stage;
import simpleray.ui.compare.Comparison;
import simpleray.ui.desktop.DesktopActions;
import simpleray.ui.desktop.PictureDialogs;
import simpleray.ui.editor.SceneMenu;
import simpleray.ui.film.TimeLine;
import simpleray.ui.inspect.Inspector;
import simpleray.ui.picture.CameraMenu;
import simpleray.ui.picture.PictureSettings;
import simpleray.ui.picture.SimpleRay;
import simpleray.ui.picture.ZoomTool;
import simpleray.ui.widget.KeyBindings;
import simpleray.ui.widget.MenuKeys;

/** The window's menus and their keys. */
final class ViewerMenus {
    private final JMenuBar bar = new JMenuBar();
    private final Action save;
    private final Action render;
    private final Action cancel;
    private final Action pause;
    private final Action regionOnly;
    private final SimpleRay picture;
    private final SceneMenu scene;
    private final DesktopActions desktop;
    private final Comparison comparison;
    private final Inspector inspector;

    ViewerMenus(SimpleRay picture, PictureDialogs dialogs, DesktopActions desktop, SceneMenu scene, Inspector inspector,
                Comparison comparison, CameraMenu camera, TimeLine timeLine, PictureSettings settings,
                Runnable quit) {
        this.picture = picture;
        this.desktop = desktop;
        this.scene = scene;
        this.comparison = comparison;
        this.inspector = inspector;
        save = KeyBindings.action("Save Picture As\u2026", "control S", dialogs::save);
        render = KeyBindings.action("Reload", "control R", picture::reload);
        desktop.addKey(render, "F5");
        pause = KeyBindings.action("Pause", "SPACE", () -> picture.setPaused(!picture.isPaused()));
        regionOnly = KeyBindings.action("Region Only", "G", () -> picture.regions().setAlone(!picture.regions().isAlone()));
        cancel = KeyBindings.action("Cancel", "ESCAPE", picture::stop);

        JMenu file = menu("File", KeyEvent.VK_F);
        file.add(scene.create());
        file.add(KeyBindings.action("Open\u2026", "control O", dialogs::open));
        desktop.addOpening(file);
        file.add(render);
        file.addSeparator();
        file.add(scene.saveAs());
        file.add(save);
        desktop.addCopying(file);
        file.add(timeLine.export());
        file.addSeparator();
        file.add(KeyBindings.action("Quit", "control Q", quit));

        JMenu view = menu("View", KeyEvent.VK_V);
        new ZoomTool(picture).addTo(view);
        view.addSeparator();
        view.add(KeyBindings.action("Region\u2026", "shift G", () -> picture.regions().ask()));
        view.add(new JCheckBoxMenuItem(regionOnly));
        view.addSeparator();
        view.add(scene.text());
        view.add(inspector.raysItem());

        comparison.addTo(view);
        view.addSeparator();
        view.add(desktop.lookMenu());

        JMenu run = menu("Render", KeyEvent.VK_R);
        ButtonGroup one = new ButtonGroup();
        addStage(run, one, Stage.ORIGINAL, "Original Scene", "1");
        addStage(run, one, Stage.LIGHTING, "With Lighting", "2");
        addStage(run, one, Stage.FINAL, "With Shadows and Reflections", "3");
        run.addSeparator();
        addStage(run, one, Stage.AMBIENT, "Ambient Term", "A");
        addStage(run, one, Stage.DIFFUSE, "Diffuse Term", "D");
        addStage(run, one, Stage.SPECULAR, "Specular Term", "S");
        run.addSeparator();
        addStage(run, one, Stage.NORMALS, "Normals", "N");
        addStage(run, one, Stage.DEPTH, "Depth", "Z");
        addStage(run, one, Stage.OBJECTS, "Object Numbers", "O");
        addStage(run, one, Stage.BOUNCES, "Bounces of Rays", "R");
        addStage(run, one, Stage.SHADOWS, "Shadows", "M");
        run.addSeparator();
        run.add(new JCheckBoxMenuItem(pause));
        run.add(cancel);
        run.addSeparator();
        run.add(timeLine.menu());
        settings.addTo(run);

        JMenu inspect = menu("Inspect", KeyEvent.VK_I);
        inspector.addTo(inspect);
        inspect.addSeparator();
        comparison.addModesTo(inspect);

        bar.add(scene.menu());
        bar.add(camera.menu());
        bar.add(desktop.helpMenu());
        MenuKeys.restWhileOpen(bar);
    }

    JMenuBar bar() {
        return bar;
    }

    /** Enables the items that can be used now. */
    void refresh(boolean busy, boolean whole, boolean scene) {
        save.setEnabled(whole);
        render.setEnabled(scene);
        cancel.setEnabled(busy);
        pause.setEnabled(busy);
        pause.putValue(Action.SELECTED_KEY, picture.isPaused());
        regionOnly.putValue(Action.SELECTED_KEY, picture.regions().isAlone());
        this.scene.refresh(scene);
        inspector.refresh(scene && !picture.isBlank());
        comparison.refresh(scene && !picture.isBlank());
        desktop.refresh();
    }

    private JMenu menu(String name, int mnemonic) {
        JMenu menu = new JMenu(name);
        menu.setMnemonic(mnemonic);
        bar.add(menu);
        return menu;
    }

    private void addStage(JMenu menu, ButtonGroup one, Stage stage, String name, String key) {
        JRadioButtonMenuItem item = new JRadioButtonMenuItem(KeyBindings.action(name, key, () -> {
            picture.setRequest(picture.request().with(stage));
            if (picture.job() != null) {
                picture.showOrRestart();
            }
        }));
        one.add(item);
        item.setSelected(picture.request().stage() == stage);
        menu.add(item);
    }
}
