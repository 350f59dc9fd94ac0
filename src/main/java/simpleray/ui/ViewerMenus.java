package simpleray.ui;

import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.ButtonGroup;
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

    ViewerMenus(ViewerFrame frame, PictureDialogs dialogs) {
        save = action("Save Picture As\u2026", "control S", dialogs::save);
        render = action("Re-render", "F5", frame::render);
        cancel = action("Cancel", "ESCAPE", () -> frame.picture().stop());

        JMenu file = menu("File", KeyEvent.VK_F);
        file.add(action("Open\u2026", "control O", dialogs::open));
        file.add(save);
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

        JMenu view = menu("View", KeyEvent.VK_V);
        ButtonGroup zoom = new ButtonGroup();
        JRadioButtonMenuItem actual = radio(zoom, action("Actual Size", "control 0", () -> frame.picture().setFitted(false)));
        actual.setSelected(true);
        view.add(actual);
        view.add(radio(zoom, action("Fit to Window", "F", () -> frame.picture().setFitted(true))));

        JMenu run = menu("Render", KeyEvent.VK_R);
        run.add(render);
        run.add(cancel);
    }

    JMenuBar bar() {
        return bar;
    }

    /** Enables what can be done now. */
    void refresh(boolean busy, boolean whole, boolean scene) {
        save.setEnabled(whole);
        render.setEnabled(scene);
        cancel.setEnabled(busy);
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

    private static Action action(String name, String key, Runnable task) {
        Action action = new AbstractAction(name) {
            private static final long serialVersionUID = 1L;

            @Override
            public void actionPerformed(ActionEvent e) {
                task.run();
            }
        };
        action.putValue(Action.ACCELERATOR_KEY, KeyStroke.getKeyStroke(key));
        return action;
    }
}
