package simpleray.ui.picture;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Words as a shell must be given them, so that each comes out as it is. */
public final class ShellWords {
    /** Words that no shell interprets. */
    private static final Pattern PLAIN = Pattern.compile("[\\p{L}\\p{N}_./:,+-][\\p{L}\\p{N}_./:,+=-]*");
    private static final Pattern PLAIN_WINDOWS = Pattern.compile("[\\p{L}\\p{N}_./:\\\\+-]+");

    private ShellWords() {
    }

    /**
     * Quotes words for the shells of Unix.
     *
     * @param words the words
     * @return the line
     */
    public static String posix(List<String> words) {
        return words.stream().map(word -> PLAIN.matcher(word).matches() ? word : quoted(word)).collect(Collectors.joining(" "));
    }

    /**
     * Quotes a word for the shells of Unix, whatever is in it.
     *
     * @param word the word
     * @return the word in quotes
     */
    public static String quoted(String word) {
        return '\'' + word.replace("'", "'\\''") + '\'';
    }

    /** {@return the line for the Command Prompt and PowerShell; a file name there has no quotes} */
    static String windows(List<String> words) {
        String line = words.stream().map(word -> PLAIN_WINDOWS.matcher(word).matches() ? word : '"' + word + '"')
            .collect(Collectors.joining(" "));
        return line.startsWith("\"") ? "& " + line : line;
    }
}
