package simpleray.ui.widget;

import java.awt.GraphicsConfiguration;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;

/** A component that draws itself, with a name for screen readers. */
public abstract class DrawnComponent extends JComponent {
    private static final long serialVersionUID = 1L;

    /**
     * Creates a component.
     *
     * @param accessibleName its name
     */
    public DrawnComponent(String accessibleName) {
        getAccessibleContext().setAccessibleName(accessibleName);
    }

    /** {@return how many screen pixels a unit of the component's size has} */
    public final double ui() {
        GraphicsConfiguration screen = getGraphicsConfiguration();
        return screen == null ? 1 : screen.getDefaultTransform().getScaleX();
    }

    @Override
    public final AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                private static final long serialVersionUID = 1L;

                @Override
                public AccessibleRole getAccessibleRole() {
                    return AccessibleRole.CANVAS;
                }
            };
        }
        return accessibleContext;
    }
}
