package simpleray.ui.desktop;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.table.DefaultTableModel;

/** Lists what the mouse does, and all keys. */
final class ShortcutsDialog extends JDialog {
    private static final long serialVersionUID = 1L;
    private static final Dimension SIZE = new Dimension(620, 460);
    private static final int[] WIDTHS = {100, 280, 200};
    private static final int MARGIN = 10;

    ShortcutsDialog(JFrame frame) {
        super(frame, "Mouse and Keys", true);
        JTabbedPane pages = new JTabbedPane();
        pages.addTab("Mouse", new JScrollPane(table("Mouse", new String[] {"Where", "What", "How"}, Shortcuts.GESTURES)));
        pages.addTab("Keys", new JScrollPane(table("Keys", new String[] {"Menu", "Command", "Key"}, Shortcuts.of(frame.getJMenuBar()))));
        pages.getAccessibleContext().setAccessibleName("Mouse and keys");
        JButton close = new JButton("Close");
        close.addActionListener(e -> dispose());
        getRootPane().setDefaultButton(close);
        getRootPane().registerKeyboardAction(e -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING));
        buttons.add(close);
        JPanel content = new JPanel(new BorderLayout(0, MARGIN));
        content.setBorder(BorderFactory.createEmptyBorder(MARGIN, MARGIN, MARGIN, MARGIN));
        content.add(pages, BorderLayout.CENTER);
        content.add(buttons, BorderLayout.SOUTH);
        setContentPane(content);
        setDefaultCloseOperation(DISPOSE_ON_CLOSE);
        setSize(SIZE);
        setLocationRelativeTo(frame);
    }

    private static JTable table(String name, String[] heads, List<Shortcuts.Shortcut> rows) {
        DefaultTableModel model = new DefaultTableModel(heads, 0) {
            private static final long serialVersionUID = 1L;

            @Override
            public boolean isCellEditable(int row, int column) {
                return false;
            }
        };
        rows.forEach(row -> model.addRow(new String[] {row.place(), row.command(), row.keys()}));
        JTable table = new JTable(model);
        table.getAccessibleContext().setAccessibleName(name);
        for (int i = 0; i < WIDTHS.length; i++) {
            table.getColumnModel().getColumn(i).setPreferredWidth(WIDTHS[i]);
        }
        // Enter is for the button, not for the next row
        table.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ENTER"), "none");
        table.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ESCAPE"), "none");
        return table;
    }
}
