package simpleray.ui;

import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.ButtonGroup;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.KeyStroke;
import simpleray.render.Stage;

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

    ViewerMenus(ViewerFrame frame, PictureDialogs dialogs, DesktopActions desktop) {
        this.desktop = desktop;
        save = action("Save Picture As\u2026", "control S", dialogs::save);
        picture = frame.picture();
        render = action("Reload", "control R", frame::render);
        desktop.addKey(render, "F5");
        pause = action("Pause", "SPACE", () -> picture.setPaused(!picture.isPaused()));
        regionOnly = action("Region Only", "G", () -> picture.regions().setAlone(!picture.regions().isAlone()));
        cancel = action("Cancel", "ESCAPE", () -> frame.picture().stop());

        JMenu file = menu("File", KeyEvent.VK_F);
        file.add(action("Open\u2026", "control O", dialogs::open));
        desktop.addOpening(file);
        file.add(render);
        file.addSeparator();
        file.add(save);
        desktop.addCopying(file);
        file.addSeparator();
        file.add(action("Quit", "control Q", frame::close));

        JMenu stage = menu("Stage", KeyEvent.VK_S);
        ButtonGroup one = new ButtonGroup();
        addStage(stage, one, frame, Stage.ORIGINAL, "Original Scene", "1");
        addStage(stage, one, frame, Stage.LIGHTING, "With Lighting", "2");
        addStage(stage, one, frame, Stage.FINAL, "With Shadows and Reflections", "3");
        stage.addSeparator();
        addStage(stage, one, frame, Stage.AMBIENT, "Ambient Term", "A");
        addStage(stage, one, frame, Stage.DIFFUSE, "Diffuse Term", "D");
        addStage(stage, one, frame, Stage.SPECULAR, "Specular Term", "S");
        stage.addSeparator();
        addStage(stage, one, frame, Stage.NORMALS, "Normals", "N");
        addStage(stage, one, frame, Stage.DEPTH, "Depth", "Z");
        addStage(stage, one, frame, Stage.OBJECTS, "Object Numbers", "O");
        addStage(stage, one, frame, Stage.BOUNCES, "Bounces of Rays", "R");
        addStage(stage, one, frame, Stage.SHADOWS, "Shadows", "M");

        scene = new SceneMenu(frame);
        JMenu view = menu("View", KeyEvent.VK_V);
        new ZoomTool(frame.picture()).addTo(view);
        view.addSeparator();
        view.add(action("Region\u2026", "shift G", () -> picture.regions().ask()));
        view.add(new JCheckBoxMenuItem(regionOnly));
        view.addSeparator();
        view.add(scene.text());

        bar.add(InspectMenu.of(frame.inspector()));

        desktop.comparison().addTo(view);
        view.addSeparator();
        view.add(desktop.lookMenu());

        JMenu run = menu("Render", KeyEvent.VK_R);
        run.add(new JCheckBoxMenuItem(pause));
        run.add(cancel);
        bar.add(scene.menu());
        bar.add(desktop.comparison().menu());
        bar.add(desktop.helpMenu());
    }

    JMenuBar bar() {
        return bar;
    }

    /** Enables what can be done now. */
    void refresh(boolean busy, boolean whole, boolean scene) {
        save.setEnabled(whole);
        render.setEnabled(scene);
        cancel.setEnabled(busy);
        pause.setEnabled(busy);
        pause.putValue(Action.SELECTED_KEY, picture.isPaused());
        regionOnly.putValue(Action.SELECTED_KEY, picture.regions().isAlone());
        this.scene.refresh(scene);
        desktop.refresh();
    }

    private JMenu menu(String name, int mnemonic) {
        JMenu menu = new JMenu(name);
        menu.setMnemonic(mnemonic);
        bar.add(menu);
        return menu;
    }

    private void addStage(JMenu menu, ButtonGroup one, ViewerFrame frame, Stage stage, String name, String key) {
        JRadioButtonMenuItem item = radio(one, action(name, key, () -> frame.setStage(stage)));
        item.setSelected(frame.picture().request().stage() == stage);
        menu.add(item);
    }

    private static JRadioButtonMenuItem radio(ButtonGroup group, Action action) {
        JRadioButtonMenuItem item = new JRadioButtonMenuItem(action);
        group.add(item);
        return item;
    }

    static Action action(String name, String key, Runnable task) {
        Action action = new AbstractAction(name) {
            private static final long serialVersionUID = 1L;

            @Override
            public void actionPerformed(ActionEvent e) {
                task.run();
            }
        };
        action.putValue(Action.ACCELERATOR_KEY, key == null ? null : KeyStroke.getKeyStroke(key));
        return action;
    }
}
