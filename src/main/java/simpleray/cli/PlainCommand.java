package simpleray.cli;

import java.util.concurrent.Callable;

/** A command whose options can be taken one by one, without picocli. */
interface PlainCommand extends Callable<Integer> {
    /** What stands in the place of a name for a word that is no option: the scene. */
    String SCENE = "";

    /**
     * Takes an option as picocli would.
     *
     * @param name an option's long name, or {@link #SCENE}
     * @return whether it is one of ours
     * @throws IllegalArgumentException if it cannot have that value
     */
    boolean take(String name, String value);

    /** {@return whether it has all that it must have} */
    boolean isComplete();

    /** {@return the command as it is called on a command line} */
    String name();
}
