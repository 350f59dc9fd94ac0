package simpleray.ui.editor;

import java.util.List;
import java.util.stream.IntStream;
import simpleray.text.SourceValue;

/**
 * Where in the edited text the values of the scene are, and what each is. Until the text is read again after a change, the values behind
 * it move along, and one that is changed keeps its name. <em>Mutable,</em> for the event thread.
 */
final class ValueTable {
    /** No values. */
    static final ValueTable NONE = new ValueTable("", List.of());

    private static final int COLOUR = 3;

    private final List<SourceValue> values;
    private final int[] starts;
    private final int[] ends;

    /** Creates the table of a text, whose values were found in its bytes in UTF-8. */
    ValueTable(String text, List<SourceValue> values) {
        this.values = values;
        starts = new int[values.size()];
        ends = new int[values.size()];
        int at = 0;
        long bytes = 0;
        for (int i = 0; i < starts.length; i++) {
            for (; bytes < values.get(i).span().start(); at++) {
                bytes += length(text.charAt(at));
            }
            starts[i] = at;
            for (; bytes < values.get(i).span().end(); at++) {
                bytes += length(text.charAt(at));
            }
            ends[i] = at;
        }
    }

    /** {@return the number of bytes of a character in UTF-8; of a pair that stands for one, each has half} */
    private static int length(char c) {
        return c < 0x80 ? 1 : c < 0x800 || Character.isSurrogate(c) ? 2 : 3;
    }

    /** Takes notice of characters that came or went; without a place for them, of those after the place. */
    void changed(int offset, int inserted, int removed) {
        for (int i = 0; i < starts.length; i++) {
            if (starts[i] > offset) {
                starts[i] = Math.max(offset, starts[i] - removed) + inserted;
            }
            if (ends[i] >= offset) {
                ends[i] = Math.max(offset, ends[i] - removed) + inserted;
            }
        }
    }

    int size() {
        return starts.length;
    }

    SourceValue value(int i) {
        return values.get(i);
    }

    int start(int i) {
        return starts[i];
    }

    int end(int i) {
        return ends[i];
    }

    /** {@return the index of the value at an offset, or that ends there; -1 for none} */
    int at(int offset) {
        int i = before(offset + 1);
        return i >= 0 && offset <= ends[i] ? i : -1;
    }

    /** {@return the index of the last value that begins before an offset; -1 for none} */
    int before(int offset) {
        int low = 0;
        int high = starts.length;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (starts[middle] < offset) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low - 1;
    }

    /** {@return the index of the red of the colour that a value is of; -1 if it is of none} */
    int colourOf(int i) {
        if (i < 0 || value(i).type() != SourceValue.Type.NUMBER) {
            return -1;
        }
        String name = value(i).name();
        int red = name.endsWith("red") ? i : name.endsWith("green") ? i - 1 : name.endsWith("blue") ? i - 2 : -1;
        return red >= 0 && red + COLOUR <= starts.length && value(red).name().endsWith("red")
            && value(red + 1).name().endsWith("green") && value(red + 2).name().endsWith("blue") ? red : -1;
    }

    /** {@return the indices of the values of an object or light} */
    int[] of(SourceValue.Thing thing) {
        return thing == null ? new int[0] : IntStream.range(0, starts.length).filter(i -> isOf(thing, value(i).thing())).toArray();
    }

    private static boolean isOf(SourceValue.Thing one, SourceValue.Thing other) {
        return other != null && one.number() == other.number() && one.what().equals(other.what());
    }

    /** {@return the index of the number of objects or lights; -1 if it is not known} */
    int count(String what) {
        return IntStream.range(0, starts.length).filter(i -> value(i).thing() == null && value(i).name().startsWith("the number of " + what))
            .findFirst().orElse(-1);
    }

    /** {@return the index of the last value of objects or lights; that of their number if there are none} */
    int last(String what) {
        return IntStream.range(0, starts.length).filter(i -> value(i).thing() != null && value(i).thing().what().equals(what))
            .reduce(count(what), (first, second) -> second);
    }

    /** {@return the object of a number; null if there is none} */
    SourceValue.Thing object(int number) {
        return values.stream().map(SourceValue::thing).filter(thing -> thing != null && thing.number() == number
            && thing.what().equals("object")).findFirst().orElse(null);
    }
}
