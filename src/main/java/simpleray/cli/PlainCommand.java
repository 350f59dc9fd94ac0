package simpleray.cli;

import java.util.List;
import java.util.concurrent.Callable;

/** A command whose line can be read without picocli. */
interface PlainCommand extends Callable<Integer> {
    /** {@return the command as it is called on a command line} */
    String name();

    /** {@return all its options} */
    List<OptionGroup> options();

    /** Takes the scene that the line names. */
    void setScene(String name);

    /** {@return whether the line must name a scene} */
    boolean needsScene();
}
