package simpleray.ui.editor;

import java.awt.Color;
import java.awt.Font;
import javax.swing.JTextArea;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.Style;
import org.fife.ui.rsyntaxtextarea.SyntaxScheme;
import org.fife.ui.rsyntaxtextarea.TokenTypes;
import org.fife.ui.rtextarea.Gutter;
import simpleray.ui.widget.Look;

/** The colours of the scene's text: those of the look around it, light or dark, and one for each kind of word. */
final class TextColours {
    private TextColours() {
    }

    static void apply(RSyntaxTextArea area, Gutter gutter) {
        JTextArea usual = new JTextArea();
        boolean dark = Look.isDark(usual);
        Color paper = usual.getBackground();
        Color ink = usual.getForeground();
        Font font = Look.monospaced();
        area.setFont(font);
        area.setBackground(paper);
        area.setForeground(ink);
        area.setCaretColor(usual.getCaretColor());
        area.setSelectionColor(usual.getSelectionColor());
        area.setSelectedTextColor(usual.getSelectedTextColor());
        area.setUseSelectedTextColor(true);
        area.setCurrentLineHighlightColor(mixed(paper, ink, 0.06));
        area.setMarkAllHighlightColor(dark ? new Color(0x5E5324) : new Color(0xFFE79A));
        SyntaxScheme scheme = new SyntaxScheme(font, false);
        for (int type = 0; type < scheme.getStyleCount(); type++) {
            scheme.setStyle(type, new Style(ink));
        }
        set(scheme, TokenTypes.COMMENT_EOL, dark ? 0x7FA870 : 0x47752F);
        set(scheme, TokenTypes.COMMENT_DOCUMENTATION, dark ? 0xC0A060 : 0x8A6100);
        set(scheme, TokenTypes.RESERVED_WORD, dark ? 0xCF8E6D : 0x0033B3);
        scheme.getStyle(TokenTypes.RESERVED_WORD).font = font.deriveFont(Font.BOLD);
        set(scheme, TokenTypes.LITERAL_NUMBER_FLOAT, dark ? 0x8FB8E8 : 0x174AD4);
        set(scheme, TokenTypes.LITERAL_STRING_DOUBLE_QUOTE, dark ? 0x6AAB9C : 0x00695C);
        set(scheme, TokenTypes.ERROR_STRING_DOUBLE, dark ? 0xFF7B72 : 0xC62828);
        set(scheme, TokenTypes.ERROR_IDENTIFIER, dark ? 0xFF7B72 : 0xC62828);
        area.setSyntaxScheme(scheme);
        gutter.setBackground(paper);
        gutter.setLineNumberColor(mixed(paper, ink, 0.5));
        gutter.setCurrentLineNumberColor(ink);
        gutter.setLineNumberFont(font);
        gutter.setBorderColor(mixed(paper, ink, 0.15));
        gutter.setIconRowHeaderInheritsGutterBackground(true);
    }

    private static void set(SyntaxScheme scheme, int type, int rgb) {
        scheme.setStyle(type, new Style(new Color(rgb)));
    }

    private static Color mixed(Color a, Color b, double share) {
        return new Color((int) Math.round(a.getRed() + share * (b.getRed() - a.getRed())),
            (int) Math.round(a.getGreen() + share * (b.getGreen() - a.getGreen())),
            (int) Math.round(a.getBlue() + share * (b.getBlue() - a.getBlue())));
    }
}
