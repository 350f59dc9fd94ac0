package simpleray.scene;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.text.NumberParser;
import simpleray.text.SceneReader;
import simpleray.text.SourceSpan;

/**
 * Edits the lines of a scene file that describe the camera: {@code camera}, or {@code window} and {@code cop}, and its keys. All other
 * bytes of the file stay as they are. <em>Mutable</em>, for one thread.
 */
public final class ViewLines {
    /** The words of a key of the camera behind the first: the frame, camera and its numbers. */
    private static final int KEY_WORDS = 2 + Key.Kind.CAMERA.channels;

    private final byte[] bytes;
    private final List<Edit> edits = new ArrayList<>();

    /** A change of a scene file. */
    public interface Change {
        /**
         * Changes a file.
         *
         * @param bytes the file's bytes
         * @param path the file, for messages and for the OBJ files beside it
         * @param reach the OBJ files that the scene may name
         * @return the bytes of the changed file
         * @throws simpleray.text.SceneFormatException if the file is no scene
         * @throws IOException if a file that the scene names cannot be read
         */
        byte[] apply(byte[] bytes, Path path, Reach reach) throws IOException;
    }

    /** A replacement of a piece of the file. */
    private record Edit(int start, int end, String text) {
    }

    private ViewLines(byte[] bytes) {
        this.bytes = bytes;
    }

    /**
     * Returns the camera of settings in the form of a scene file.
     *
     * @param view the settings
     * @return one or two lines, each ended by LF; empty if they have no camera
     */
    public static String of(SceneSettings view) {
        SceneSettings camera = new SceneSettings();
        camera.setCamera(view);
        return camera.lines().replaceAll("\\.0(?=\\s)", "");      // a person would not write 90.0
    }

    /**
     * Writes a camera into a scene file. Equal numbers stay as they are written; a new line replaces one that it excludes, or
     * follows the scene's last value.
     *
     * @param bytes the file's bytes
     * @param path the file, for messages and for the OBJ files beside it
     * @param view settings with the camera
     * @param reach the OBJ files that the scene may name
     * @return the bytes of the changed file, which has exactly this camera
     * @throws simpleray.text.SceneFormatException if the file is no scene
     * @throws IOException if a file that the scene names cannot be read
     */
    public static byte[] put(byte[] bytes, Path path, SceneSettings view, Reach reach) throws IOException {
        ViewLines file = new ViewLines(bytes);
        file.edit(read(bytes, path, reach), of(view).lines().toList(), true);
        return file.edited();
    }

    /**
     * Writes settings that are not of the camera into a scene file, as the other method does; those that are not given stay as they are.
     *
     * @param bytes the file's bytes
     * @param path the file, for messages and for the OBJ files beside it
     * @param settings the settings, each of numbers alone
     * @param reach the OBJ files that the scene may name
     * @return the bytes of the changed file
     * @throws simpleray.text.SceneFormatException if the file is no scene
     * @throws IOException if a file that the scene names cannot be read
     */
    public static byte[] putSettings(byte[] bytes, Path path, SceneSettings settings, Reach reach) throws IOException {
        ViewLines file = new ViewLines(bytes);
        file.edit(read(bytes, path, reach), settings.lines().lines().toList(), false);
        return file.edited();
    }

    /**
     * Writes a key of the camera into the file of a film. Numbers of a key that is there already for that frame are changed; a new key
     * follows the one of the frame before it. A camera that can have no keys is replaced by one that can.
     *
     * @param bytes the file's bytes
     * @param path the file, for messages and for the OBJ files beside it
     * @param frame the frame
     * @param pose where the camera is then
     * @param reach the OBJ files that the scene may name
     * @return the bytes of the changed file
     * @throws simpleray.text.SceneFormatException if the file is no scene
     * @throws IOException if a file that the scene names cannot be read
     */
    public static byte[] putKey(byte[] bytes, Path path, int frame, Pose pose, Reach reach) throws IOException {
        SceneSettings old = read(bytes, path, reach);
        SceneSettings view = new SceneSettings();
        view.camera = pose;
        if (old.hasCamera() && old.camera == null && !old.hasCameraKeys()) {
            byte[] free = put(bytes, path, view, reach);
            return putKey(free, path, frame, pose, reach);
        }
        ViewLines file = new ViewLines(bytes);
        file.editKeys(old, frame, of(view).strip());
        return file.edited();
    }

    private static SceneSettings read(byte[] bytes, Path path, Reach reach) throws IOException {
        Scene scene = new Scene();
        try (SceneReader reader = SourceSpan.reader(bytes, path)) {
            MeshFiles.of(reader, reach);
            scene.read(reader);
        }
        return scene.settings;
    }

    /** {@return the indices of the camera's keys, in the order of their frames} */
    private static List<Integer> cameraKeys(SceneSettings settings) {
        return settings.keys == null ? List.of() : IntStream.range(0, settings.keys.size()).boxed()
            .filter(i -> settings.keys.get(i).thing().kind() == Key.Kind.CAMERA)
            .sorted(Comparator.comparingDouble(i -> settings.keys.get(i).frame())).toList();
    }

    private void editKeys(SceneSettings old, int frame, String camera) throws IOException {
        String line = "key " + frame + ' ' + camera;
        int begin = -1;                                       // of the first key behind the frame
        int end = -1;                                         // of the last one before it
        for (int i : cameraKeys(old)) {
            double at = old.keys.get(i).frame();
            int start = startOfLine(old.keyLines.get(i));
            List<SourceSpan> words = keyWords(start);
            if (at == frame) {
                renumber(words.subList(KEY_WORDS - Key.Kind.CAMERA.channels, KEY_WORDS), camera.split(" "));
                return;
            }
            begin = at > frame && begin < 0 ? start : begin;
            end = at < frame ? (int) words.get(KEY_WORDS - 1).end() : end;
        }
        if (end < 0 && begin >= 0) {
            edits.add(new Edit(begin, begin, line + lineBreak()));
        } else {
            insert(end < 0 ? (int) old.last.end() : end, List.of(line));
        }
    }

    /** {@return the words of a camera's key, without the first, which would begin a heading} */
    private List<SourceSpan> keyWords(int line) throws IOException {
        int key = line;
        while (isBlank(key)) {
            key++;
        }
        return new SourceSpan(key + Setting.KEY.keyword().length(), bytes.length).words(bytes).subList(0, KEY_WORDS);
    }

    /** {@return the index at which a line begins; lines are counted from 1} */
    private int startOfLine(long number) {
        int start = 0;
        for (long line = 1; line < number; line++) {
            while (!isBreak(start)) {
                start++;
            }
            start = behindBreak(start);
        }
        return start;
    }

    private void edit(SceneSettings old, List<String> wanted, boolean camera) throws IOException {
        List<String> lines = new ArrayList<>(wanted);
        List<String> gone = new ArrayList<>(old.places.keySet());
        gone.removeIf(keyword -> camera ? !Setting.of(keyword).isOfCamera()
            : wanted.stream().noneMatch(line -> line.startsWith(keyword + " ")));
        gone.sort(Comparator.comparingLong(keyword -> old.places.get(keyword).start()));
        for (String line : wanted) {
            String keyword = line.split(" ", 2)[0];
            if (gone.remove(keyword)) {
                renumber(values(keyword, old.places.get(keyword)), line.split(" "));
                lines.remove(line);
            }
        }
        for (String keyword : gone) {
            SourceSpan place = old.places.get(keyword);
            String line = lines.isEmpty() ? "" : lines.remove(0);
            replace(place, (int) place.start() + keyword.length(), values(keyword, place), line);
        }
        insert((int) old.last.end(), lines);
    }

    private List<SourceSpan> values(String keyword, SourceSpan place) throws IOException {
        return new SourceSpan(place.start() + keyword.length(), place.end()).words(bytes);
    }

    /** Replaces numbers, except equal ones. */
    private void renumber(List<SourceSpan> words, String[] line) {
        for (int i = 0; i < words.size(); i++) {
            SourceSpan word = words.get(i);
            String now = text((int) word.start(), (int) word.end());
            if (Double.compare(NumberParser.parseDouble(now), Double.parseDouble(line[i + 1])) != 0) {
                edits.add(new Edit((int) word.start(), (int) word.end(), line[i + 1]));
            }
        }
    }

    /** Replaces a keyword and its values by a line; without a line, also removes lines of the file that become empty. */
    private void replace(SourceSpan place, int keywordEnd, List<SourceSpan> words, String line) {
        List<Edit> taken = new ArrayList<>();
        taken.add(new Edit((int) place.start(), keywordEnd, line));
        for (SourceSpan word : words) {
            int start = (int) word.start();
            while (isBlank(start - 1)) {
                start--;
            }
            taken.add(new Edit(start, (int) word.end(), ""));
        }
        for (int i = 0; i < taken.size(); i++) {
            int begin = lineStart(taken.get(i).start);
            int from = i;
            while (i + 1 < taken.size() && lineStart(taken.get(i + 1).start) == begin) {
                i++;
            }
            int end = taken.get(i).end;
            while (isBlank(end)) {
                end++;
            }
            boolean empty = taken.subList(from, i + 1).stream().allMatch(e -> e.text.isEmpty())
                && text(begin, taken.get(from).start).isBlank() && (end == bytes.length || isBreak(end));
            edits.addAll(empty ? List.of(new Edit(begin, behindBreak(end), "")) : taken.subList(from, i + 1));
        }
    }

    /** Adds lines after the line in which the scene's last value ends. */
    private void insert(int lastEnd, List<String> lines) {
        int end = lastEnd;
        while (end < bytes.length && !isBreak(end)) {
            end++;
        }
        boolean open = end == bytes.length;                   // the last line of the file, without a line break
        String added = String.join(lineBreak(), lines);
        if (!lines.isEmpty()) {
            edits.add(new Edit(behindBreak(end), behindBreak(end), open ? lineBreak() + added : added + lineBreak()));
        }
    }

    private byte[] edited() {
        edits.sort(Comparator.comparingInt(Edit::start));
        ByteArrayOutputStream out = new ByteArrayOutputStream(bytes.length);
        int at = 0;
        for (Edit edit : edits) {
            out.write(bytes, at, edit.start - at);
            out.writeBytes(edit.text.getBytes(StandardCharsets.US_ASCII));
            at = edit.end;
        }
        out.write(bytes, at, bytes.length - at);
        return out.toByteArray();
    }

    /** {@return the bytes as characters, one each} */
    private String text(int from, int to) {
        return new String(Arrays.copyOfRange(bytes, from, to), StandardCharsets.ISO_8859_1);
    }

    private int lineStart(int index) {
        int start = index;
        while (start > 0 && !isBreak(start - 1)) {
            start--;
        }
        return start;
    }

    private boolean isBlank(int index) {
        return index >= 0 && index < bytes.length && (bytes[index] == ' ' || bytes[index] == '\t');
    }

    private boolean isBreak(int index) {
        return bytes[index] == '\n' || bytes[index] == '\r';
    }

    /** {@return the index after the line break here; the same index at the end of the file} */
    private int behindBreak(int index) {
        boolean two = index + 1 < bytes.length && bytes[index] == '\r' && bytes[index + 1] == '\n';
        return Math.min(bytes.length, index + (two ? 2 : 1));
    }

    /** {@return the line break that the file uses first; LF if it has none} */
    private String lineBreak() {
        int i = 0;
        while (i < bytes.length && !isBreak(i)) {
            i++;
        }
        return i == bytes.length ? "\n" : text(i, behindBreak(i));
    }
}
