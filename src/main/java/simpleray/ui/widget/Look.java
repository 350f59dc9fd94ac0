package simpleray.ui.widget;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.awt.Component;
import java.awt.Font;
import java.util.Locale;
import javax.swing.JTextArea;

/** How the window looks. */
public enum Look {
    /** Dark on light. */
    LIGHT,
    /** Light on dark. */
    DARK,
    /** As the desktop is set; light where that cannot be known. */
    SYSTEM;

    private static final int HALF = 128;

    /** {@return whether it is dark now} Asks the desktop, which may take half a second; not for the event thread. */
    public boolean isDark() {
        return this == DARK || this == SYSTEM && DesktopTheme.ofThisDesktop().isDark();
    }

    /**
     * Sets the look of all windows, those that are open too. For the event thread.
     *
     * @param dark whether it is dark
     */
    public static void install(boolean dark) {
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
        FlatLaf.updateUI();
    }

    /**
     * {@return whether a component has a dark look, with light text}
     *
     * @param component the component
     */
    public static boolean isDark(Component component) {
        Color ink = component.getForeground();
        return ink != null && (299 * ink.getRed() + 587 * ink.getGreen() + 114 * ink.getBlue()) / 1000 > HALF;
    }

    /** {@return a font for texts of which columns matter, as large as that of other texts} */
    public static Font monospaced() {
        Font usual = new JTextArea().getFont();
        return new Font(Font.MONOSPACED, Font.PLAIN, usual == null ? 12 : usual.getSize());
    }

    /** {@return the name as the command line has it, in lower case} */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
