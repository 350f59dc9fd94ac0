package simpleray.text;

import java.io.Closeable;
import java.io.File;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;

/**
 * Reads values from a scene file (thesis, chapter 5). <em>Mutable</em>, for one thread.
 * <p>Values are words between white space. {@code #} begins a comment that ends with its line. A line that begins with a letter
 * is a heading: it is skipped, with a warning. Each class names what it reads, by {@link #enter(String, int) enter("object", 3)} and
 * then {@link #readDouble(String) readDouble("radius")}, so that an error can say "expected object 3's radius".
 *
 * <p>The first error throws, unless {@link #tolerate} allows more; then a bad number is noted and read as NaN, and reading goes on
 * until {@link #complete}. An error after which the rest cannot be read throws at once, with those noted before it.
 */
public final class SceneReader implements Closeable {
    private static final int BUFFER = 1 << 16;
    private static final Set<String> NO_KEYWORDS = Set.of();

    private final Diagnostics diagnostics;
    private final Path folder;
    final Tokenizer tokenizer;
    private final Map<Class<?>, Object> kept = new HashMap<>();
    private SourceValues values;                              // null unless they are asked for
    private SourceValue.Thing thing;                          // that the next values belong to; null for none, or none is asked for

    /**
     * Opens a scene file.
     *
     * @param f the file, UTF-8; its path as given stands in messages
     * @throws IOException if it cannot be opened
     */
    public SceneReader(File f) throws IOException {
        this(new FileInputStream(f), f.getPath(), f.toPath().resolveSibling(""), BUFFER);
    }

    /**
     * Creates a reader of a stream, which messages call {@code <stdin>}.
     *
     * @param is the stream, UTF-8
     */
    public SceneReader(InputStream is) {
        this(is, "<stdin>", Path.of(""));
    }

    /**
     * Creates a reader of a stream that stands for a file.
     *
     * @param is the stream, UTF-8
     * @param name what messages call the file
     * @param folder the folder of the files that it names
     */
    public SceneReader(InputStream is, String name, Path folder) {
        this(is, name, folder, BUFFER);
    }

    /** Creates a reader that keeps so many bytes in memory, at least 4096. */
    SceneReader(InputStream is, String name, Path folder, int buffer) {
        diagnostics = new Diagnostics(name);
        this.folder = folder;
        tokenizer = new Tokenizer(is, buffer, diagnostics);
    }

    /**
     * Returns the object of a class that all who read this file share.
     *
     * @param <T> the class
     * @param type the class
     * @param maker creates the object when it is first asked for
     * @return the object, the same each time
     */
    public <T> T kept(Class<T> type, Function<Class<?>, T> maker) {
        return type.cast(kept.computeIfAbsent(type, maker));
    }

    /**
     * Lets reading go on after a bad number, until there are too many.
     *
     * @param max the number of errors that ends reading, 1 or more
     */
    public void tolerate(int max) {
        diagnostics.tolerate(max);
    }

    /**
     * Lists the values that are read from here on. Without this, none is listed.
     *
     * @param list gets them; null to list none
     */
    public void list(SourceValues list) {
        values = list;
    }

    /**
     * Tells the kind of the thing that the next values belong to, which the value just read has decided.
     *
     * @param count how many such things there are
     * @param kind its kind
     * @param field what the value just read is
     */
    public void specify(int count, String kind, String field) {
        if (values != null) {
            thing = diagnostics.thing(count, kind);
            values.give(thing, field);
        }
    }

    /**
     * Names the thing that the next values belong to, until {@link #leave}: "object" and 3 give "object 3's …".
     *
     * @param name the thing's name
     * @param number its number, from 1
     */
    public void enter(String name, int number) {
        diagnostics.enter(name, number);
    }

    /**
     * Names the thing that the next values belong to, until {@link #leave}.
     *
     * @param name the thing's name, as it stands before "red" or "x"
     */
    public void enter(String name) {
        diagnostics.enter(name, 0);
    }

    /** Ends what the latest {@code enter} began. */
    public void leave() {
        diagnostics.leave();
        if (diagnostics.isOutside()) {
            thing = null;
        }
    }

    /**
     * Reads the next character that is neither white space nor in a comment.
     *
     * @return the character
     * @throws IOException at the end of the file, or if it cannot be read
     */
    public char readChar() throws IOException {
        require(null, "a character");
        return tokenizer.takeChar();
    }

    /**
     * {@return the next number, finite}
     *
     * @throws IOException if the next word is no number, or the file cannot be read
     */
    public double readDouble() throws IOException {
        return readDouble("a number");
    }

    /**
     * Reads a number.
     *
     * @param field what it is, for the message
     * @return the number, finite; NaN if it was bad and that was {@link #tolerate tolerated}
     * @throws IOException if the next word is no number, or the file cannot be read
     */
    public double readDouble(String field) throws IOException {
        return readDouble(field, field);
    }

    /**
     * Reads a number, where something else could stand, too.
     *
     * @param field what it is
     * @param wanted what could stand here, for the message
     * @return the number, finite; NaN if it was bad and that was {@link #tolerate tolerated}
     * @throws IOException if the next word is no number, or the file cannot be read
     */
    public double readDouble(String field, String wanted) throws IOException {
        double value = tokenizer.takeDouble();
        if (Double.isNaN(value)) {
            String word = word(wanted, false);
            value = NumberParser.parseDouble(word);
            if (Double.isNaN(value)) {
                refuse(wanted);
            } else if (value == 0 && NumberParser.isTiny(word)) {
                diagnostics.warn(tokenizer.last(), field + ' ' + Diagnostic.quoted(tokenizer.lastWord()) + " is too small for a number, and read as 0");
            }
        }
        listLast(field, SourceValue.Type.NUMBER);
        return value;
    }

    /**
     * Reads a number of single precision.
     *
     * @return the float nearest to the number, finite; NaN if it was bad and that was {@link #tolerate tolerated}
     * @throws IOException if the next word is no number, or the file cannot be read
     */
    public float readFloat() throws IOException {
        float value = NumberParser.parseFloat(word("a number", false));
        if (Float.isNaN(value)) {
            refuse("a number");
        }
        listLast("a number", SourceValue.Type.NUMBER);
        return value;
    }

    /**
     * {@return the next integer}
     *
     * @throws IOException if the next word is no integer of that range, or the file cannot be read
     */
    public int readInt() throws IOException {
        return readInt("an integer", Integer.MIN_VALUE, Integer.MAX_VALUE);
    }

    /**
     * Reads an integer on which the reading of what follows depends: a bad one is never tolerated.
     *
     * @param field what it is, for the message
     * @param min the smallest integer allowed
     * @param max the largest integer allowed
     * @return the integer
     * @throws IOException if the next word is no such integer, or the file cannot be read
     */
    public int readInt(String field, int min, int max) throws IOException {
        return (int) readInteger(field, min, max);
    }

    /**
     * {@return the next long integer}
     *
     * @throws IOException if the next word is no integer of that range, or the file cannot be read
     */
    public long readLong() throws IOException {
        return readInteger("an integer", Long.MIN_VALUE, Long.MAX_VALUE);
    }

    private long readInteger(String field, long min, long max) throws IOException {
        long value = tokenizer.takeInteger();
        if (value == NumberParser.NO_INTEGER || value < min || value > max) {
            Long other = value == NumberParser.NO_INTEGER ? NumberParser.parseInteger(word(field, true), min, max) : null;
            if (other == null) {
                throw diagnostics.stop(tokenizer.last(), field, BadNumber.describeInteger(tokenizer.lastWord(), min, max));
            }
            value = other;
        }
        listLast(field, SourceValue.Type.INTEGER);
        return value;
    }

    /**
     * Reads a name between double quotes on one line, in which white space and {@code #} are allowed; it must fit into the buffer.
     *
     * @param field what it is, for the message
     * @return the name without the quotes, not empty
     * @throws IOException if the next word is not quoted, or the file cannot be read
     */
    public String readQuoted(String field) throws IOException {
        String word = word(field, false);
        int close = word.indexOf('"', 1);
        if (!word.startsWith("\"") || close < 2 || close != word.length() - 1) {
            throw stop(field + " between double quotes");
        }
        listLast(field, SourceValue.Type.WORD);
        return word.substring(1, close);
    }

    /**
     * Returns the path of a file that the scene names.
     *
     * @param name the name, as it stands in the scene file
     * @return the file's path: relative to the scene file's folder, or to the working directory if the scene comes from a stream
     * @throws java.nio.file.InvalidPathException if no file can have that name
     */
    public Path resolve(String name) {
        return folder.resolve(name);
    }

    /**
     * {@return whether only white space, comments and headings are left}
     *
     * @throws IOException if the file cannot be read
     */
    public boolean eof() throws IOException {
        return !tokenizer.skip(NO_KEYWORDS);
    }

    /**
     * Reads a keyword, if one comes next.
     *
     * @param keywords the keywords that may stand here, and so begin no heading; each begins with a letter from A to Z or a to z
     * @return the keyword; null if none comes next
     * @throws IOException if the file cannot be read
     */
    public String takeKeyword(Set<String> keywords) throws IOException {
        String word = tokenizer.skip(keywords) && tokenizer.isNext(keywords) ? tokenizer.take(false) : null;
        if (values != null && word != null) {
            listLast("keyword " + word, SourceValue.Type.WORD);
        }
        return word;
    }

    /**
     * Reads one of some words.
     *
     * @param field what it is, for the message
     * @param words the words, which begin no heading here; each begins with a letter from A to Z or a to z
     * @return the word
     * @throws IOException if the next word is none of them, or the file cannot be read
     */
    public String readWord(String field, Set<String> words) throws IOException {
        require(words, field);
        String word = tokenizer.take(false);
        if (!words.contains(word)) {
            throw stop(field);
        }
        listLast(field, SourceValue.Type.WORD);
        return word;
    }

    /** {@return the place of the value just read, for {@link #rejectAt}} */
    public SourceLocation location() {
        return tokenizer.last();
    }

    /** {@return the line of the value just read, from 1} */
    public int line() {
        return tokenizer.line();
    }

    /** {@return whether the value just read is the first on its line} */
    public boolean isFirstOnLine() {
        return tokenizer.isFirstOnLine();
    }

    /** Begins a group: the values read from here on may be rejected together. */
    public void group() {
        tokenizer.beginGroup();
    }

    /**
     * Notes that the value just read is out of its range.
     *
     * @param wanted what was expected instead
     * @throws SceneFormatException if that is one error too many
     */
    public void reject(String wanted) throws SceneFormatException {
        diagnostics.note(tokenizer.last(), wanted, BadNumber.describe(tokenizer.lastWord()));
    }

    /**
     * Notes that a value that was read before is wrong.
     *
     * @param place where it is
     * @param wanted what was expected instead
     * @param found what was found
     * @throws SceneFormatException if that is one error too many
     */
    public void rejectAt(SourceLocation place, String wanted, String found) throws SceneFormatException {
        diagnostics.note(place, wanted, found);
    }

    /**
     * Notes a problem in another file that the scene names.
     *
     * @param problem the error or warning
     * @throws SceneFormatException if that is one error too many
     */
    public void report(Diagnostic problem) throws SceneFormatException {
        diagnostics.report(problem);
    }

    /**
     * Notes an error in another file that the scene names.
     *
     * @param error the error, after warnings that are told with it
     * @throws SceneFormatException if that is one error too many
     */
    public void report(List<Diagnostic> error) throws SceneFormatException {
        diagnostics.report(error);
    }

    /**
     * Notes that the values read since {@link #group} make no sense together. The error is located at the first of them.
     *
     * @param wanted what was expected instead
     * @throws SceneFormatException if that is one error too many
     */
    public void rejectGroup(String wanted) throws SceneFormatException {
        diagnostics.note(tokenizer.group(), wanted, Diagnostic.quoted(tokenizer.groupWords()));
    }

    /**
     * Notes that the value just read is wrong, and that the rest cannot be read without it.
     *
     * @param wanted what was expected instead
     * @return the exception to throw, with all errors so far
     */
    public SceneFormatException stop(String wanted) {
        return diagnostics.stop(tokenizer.last(), wanted, BadNumber.describe(tokenizer.lastWord()));
    }

    /**
     * Requires that nothing is left but comments and headings, and that no error was noted.
     *
     * @param wanted what was expected if something is left
     * @throws IOException if an error was noted or something is left, or the file cannot be read
     */
    public void complete(String wanted) throws IOException {
        if (tokenizer.skip(NO_KEYWORDS)) {
            tokenizer.markNext();
            throw stop(wanted);
        }
        diagnostics.complete();
    }

    /** {@return the warnings so far, in the order of the file; the first thousand of them} */
    public List<Diagnostic> warnings() {
        return diagnostics.warnings();
    }

    @Override
    public void close() throws IOException {
        tokenizer.close();
    }

    private void listLast(String field, SourceValue.Type type) {
        if (values != null) {
            values.add(tokenizer.lastSpan(), thing, diagnostics.owner(thing == null ? 0 : 1) + field, type);
        }
    }

    private String word(String field, boolean integer) throws IOException {
        require(NO_KEYWORDS, field);
        return tokenizer.take(integer);
    }

    /** Notes that the word just read is no number; throws if it was not read to its end. */
    private void refuse(String field) throws SceneFormatException {
        if (tokenizer.isCut()) {
            throw stop(field);
        }
        reject(field);
    }

    private void require(Set<String> keywords, String field) throws IOException {
        if (!tokenizer.skip(keywords)) {
            throw diagnostics.stop(tokenizer.here(), field, diagnostics.end());
        }
    }
}
