package simpleray.ui.widget;

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
