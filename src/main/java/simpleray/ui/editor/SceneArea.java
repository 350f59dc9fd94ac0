package simpleray.ui.editor;

import java.awt.Color;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.KeyStroke;
import javax.swing.ToolTipManager;
import javax.swing.text.BadLocationException;
import javax.swing.text.Highlighter;
import org.fife.ui.rsyntaxtextarea.RSyntaxDocument;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.SquiggleUnderlineHighlightPainter;
import org.fife.ui.rtextarea.Gutter;
import simpleray.text.Diagnostic;
import simpleray.ui.widget.KeyBindings;
import simpleray.ui.widget.WarningIcon;

/** The text of a scene, coloured, with its problems marked. */
final class SceneArea extends RSyntaxTextArea {
    private static final long serialVersionUID = 1L;
    /** Keys that editors have for something, and this window for something else. */
    private static final String[] WINDOWS = {"control ENTER", "control ADD", "control SUBTRACT"};

    private final transient List<Mark> marks = new ArrayList<>();

    /** A marked piece of the text, which moves with it. */
    private record Mark(Highlighter.Highlight place, Diagnostic problem) {
    }

    SceneArea() {
        ((RSyntaxDocument) getDocument()).setSyntaxStyle(new SceneTokens());
        setName("scene-text");
        getAccessibleContext().setAccessibleName("Scene text");
        setTabSize(4);
        setCodeFoldingEnabled(false);
        setBracketMatchingEnabled(false);
        setCloseCurlyBraces(false);
        setInsertPairedCharacters(false);
        setAutoIndentEnabled(true);
        for (String key : WINDOWS) {
            getInputMap().put(KeyStroke.getKeyStroke(key), "none");
        }
        ToolTipManager.sharedInstance().registerComponent(this);
    }

    /** Marks problems, each with a wavy line and a sign in the gutter, in place of those that were marked. */
    void mark(List<Diagnostic> problems, Gutter gutter) {
        marks.forEach(mark -> getHighlighter().removeHighlight(mark.place));
        marks.clear();
        gutter.removeAllTrackingIcons();
        SquiggleUnderlineHighlightPainter red = new SquiggleUnderlineHighlightPainter(new Color(0xE5443F));
        SquiggleUnderlineHighlightPainter amber = new SquiggleUnderlineHighlightPainter(new Color(0xD99A00));
        try {
            for (Diagnostic problem : problems) {
                int from = offset(problem.line(), problem.column());
                int to = wordEnd(from);
                int shown = to > from ? from : Math.max(0, from - 1);     // at an end of the text: the character before it
                marks.add(new Mark((Highlighter.Highlight) getHighlighter().addHighlight(shown, to, problem.error() ? red : amber),
                    problem));
                gutter.addOffsetTrackingIcon(from, new WarningIcon(problem.error()), problem.message());
            }
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);               // all offsets are of this text
        }
    }

    /** {@return the messages of the marks, each with the text that is marked} */
    List<String> marked() {
        return marks.stream().map(mark -> {
            int from = mark.place.getStartOffset();
            return getText().substring(from, mark.place.getEndOffset()) + ": " + mark.problem.message();
        }).toList();
    }

    /** {@return the offset of a line and a column, both counted from 1; beyond the text, the nearest offset} */
    int offset(int line, int column) {
        try {
            if (line > getLineCount()) {
                return getDocument().getLength();
            }
            int from = getLineStartOffset(line - 1);
            int end = line == getLineCount() ? getDocument().getLength() : getLineEndOffset(line - 1) - 1;
            String text = getText(from, end - from);
            return from + text.offsetByCodePoints(0, Math.min(column - 1, text.codePointCount(0, text.length())));
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);               // the line is one of this text
        }
    }

    private int wordEnd(int from) throws BadLocationException {
        int end = from;
        while (end < getDocument().getLength() && !Character.isWhitespace(getText(end, 1).charAt(0)) && getText(end, 1).charAt(0) != '#') {
            end++;
        }
        return end;
    }

    /** Replaces the text, except for an equal start and end, so that carets stay and it can be undone. */
    void replaceAll(String text) {
        String now = getText();
        int same = 0;
        int least = Math.min(now.length(), text.length());
        while (same < least && now.charAt(same) == text.charAt(same)) {
            same++;
        }
        int below = 0;
        while (below < least - same && now.charAt(now.length() - 1 - below) == text.charAt(text.length() - 1 - below)) {
            below++;
        }
        replaceRange(text.substring(same, text.length() - below), same, now.length() - below);
    }

    /** {@return the messages of the problems at a place; null for none} */
    @Override
    public String getToolTipText(MouseEvent e) {
        int at = viewToModel2D(e.getPoint());
        StringBuilder tip = new StringBuilder();
        for (Mark mark : marks) {
            if (at >= mark.place.getStartOffset() && at <= mark.place.getEndOffset()) {
                tip.append(tip.length() == 0 ? "" : "\n").append(mark.problem.message());
            }
        }
        return tip.length() == 0 ? null : tip.toString();
    }

    @Override
    protected boolean processKeyBinding(KeyStroke key, KeyEvent e, int condition, boolean pressed) {
        return super.processKeyBinding(key, e, condition, pressed) || condition == WHEN_FOCUSED && KeyBindings.isCharacter(e);
    }
}
