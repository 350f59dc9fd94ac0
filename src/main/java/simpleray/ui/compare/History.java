package simpleray.ui.compare;

import java.util.ArrayList;
import java.util.List;

/** The last pictures that were finished, as many as fit into some memory, eight at most. For the event thread. */
final class History {
    /** The most pictures that are kept. */
    static final int MAX = 8;
    /** The share of the memory that they may take. */
    private static final int SHARE = 8;

    private final List<FinishedRender> pictures = new ArrayList<>();
    private final long room;

    History() {
        this(Runtime.getRuntime().maxMemory() / SHARE);
    }

    /** Creates a history that may take a number of bytes. */
    History(long room) {
        this.room = room;
    }

    /** Keeps a picture; the oldest go, if there is not room for all. */
    void add(FinishedRender picture) {
        pictures.add(picture);
        long bytes = pictures.stream().mapToLong(FinishedRender::bytes).sum();
        while (pictures.size() > MAX || !pictures.isEmpty() && bytes > room) {
            bytes -= pictures.remove(0).bytes();
        }
    }

    /** {@return the pictures whose pixels are there, the latest last} */
    List<FinishedRender> pictures() {
        pictures.removeIf(picture -> picture.pixels() == null);
        return List.copyOf(pictures);
    }
}
