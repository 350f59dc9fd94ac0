package simpleray.text;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;

/**
 * Writes values to a file (thesis, chapter 5): UTF-8, lines end with LF. <em>Mutable</em>, for one thread.
 *
 * <p>Numbers are written as the shortest decimal that reads back as the same number, and two numbers in a row are kept apart by a
 * space, so that a {@link SceneReader} reads what was written.
 */
public final class SceneWriter implements Closeable {
    private final Writer out;
    private boolean afterNumber;

    /**
     * Creates a file, or empties the one that is there.
     *
     * @param f the file
     * @throws IOException if it cannot be created
     */
    public SceneWriter(File f) throws IOException {
        this(new FileOutputStream(f));
    }

    /**
     * Creates a writer to a stream.
     *
     * @param os the stream
     */
    public SceneWriter(OutputStream os) {
        out = new BufferedWriter(new OutputStreamWriter(os, StandardCharsets.UTF_8));
    }

    /**
     * Writes out what is buffered.
     *
     * @throws IOException if it cannot be written
     */
    public void flush() throws IOException {
        out.flush();
    }

    /**
     * Writes a character.
     *
     * @param c the character
     * @throws IOException if it cannot be written
     */
    public void writeChar(char c) throws IOException {
        out.write(c);
        afterNumber = false;
    }

    /**
     * Writes a number.
     *
     * @param d the number
     * @throws IOException if it cannot be written
     */
    public void writeDouble(double d) throws IOException {
        writeNumber(ShortestDecimal.of(d));
    }

    /**
     * Writes a number of single precision.
     *
     * @param f the number
     * @throws IOException if it cannot be written
     */
    public void writeFloat(float f) throws IOException {
        writeNumber(ShortestDecimal.of(f));
    }

    /**
     * Writes an integer.
     *
     * @param i the integer
     * @throws IOException if it cannot be written
     */
    public void writeInt(int i) throws IOException {
        writeNumber(Integer.toString(i));
    }

    /**
     * Writes a long integer.
     *
     * @param l the integer
     * @throws IOException if it cannot be written
     */
    public void writeLong(long l) throws IOException {
        writeNumber(Long.toString(l));
    }

    /**
     * Ends the line.
     *
     * @throws IOException if it cannot be written
     */
    public void writeNewline() throws IOException {
        writeChar('\n');
    }

    /**
     * Writes text.
     *
     * @param s the text
     * @throws IOException if it cannot be written
     */
    public void writeString(String s) throws IOException {
        out.write(s);
        afterNumber = afterNumber && s.isEmpty();
    }

    /**
     * Closes the file when finished.
     *
     * @throws IOException if what was written last cannot be
     */
    @Override
    public void close() throws IOException {
        out.close();
    }

    private void writeNumber(String digits) throws IOException {
        if (afterNumber) {
            out.write(' ');
        }
        out.write(digits);
        afterNumber = true;
    }
}
