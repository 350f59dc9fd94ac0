package simpleray.ui;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junitpioneer.jupiter.RetryingTest;

/**
 * A test with a window on the screen. If it fails it has one more try: keys, focus and windows pass through an X server that other programs
 * keep busy, too. A try that failed is told among the skipped tests, with its reason (docs/decisions/0018).
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.METHOD)
@RetryingTest(maxAttempts = 2)
public @interface WindowTest {
}
