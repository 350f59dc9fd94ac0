package simpleray.ui;

import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.JLabel;

/** Says in the status bar how large the picture is shown. */
final class ZoomLabel extends JLabel {
    private static final long serialVersionUID = 1L;

    ZoomLabel(ZoomedComponent picture) {
        setName("zoom");
        getAccessibleContext().setAccessibleDescription("Zoom");
        picture.addPropertyChangeListener(ZoomedComponent.ZOOM, e -> show(picture));
        picture.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                ZoomLabel.this.show(picture);                 // a fitted picture grows with the window
            }
        });
        show(picture);
    }

    private void show(ZoomedComponent picture) {
        setText(Zoom.percent(picture.placed().scale()));
    }
}
