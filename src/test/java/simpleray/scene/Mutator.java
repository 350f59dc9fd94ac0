package simpleray.scene;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** Makes mutants of texts: what editors, disks, mail and people do to a file, and what they would never do. */
final class Mutator {
    private static final List<String> NASTY = List.of("NaN", "Infinity", "1e400", "-1e400", "0x10", "1,5", "-1", "0", "-0", "1e9", "2147483648",
        "2147483647", "1e-400", "1e308", "1e154", "4.9e-324", "9".repeat(40), "0." + "0".repeat(400) + "1", "\"", "\"x\"", "#", "transmit", "mirror",
        "camera", "parallel", "up", "depth", "window", "4", "99", "\0", "\uFEFF", "\u0661", "\u2028", "abc", "\n",
        "\r", ".", "-", "1e", "\"../x.obj\"", "f", "vn");
    private static final int MAX_CHANGES = 3;

    private final Random random;
    private final List<byte[]> texts;

    Mutator(long seed, List<byte[]> texts) {
        random = new Random(seed);
        this.texts = texts;
    }

    /** {@return a mutant of one of the texts} */
    byte[] next() {
        byte[] mutant = texts.get(random.nextInt(texts.size()));
        for (int changes = 1 + random.nextInt(MAX_CHANGES); changes > 0; changes--) {
            mutant = changed(mutant);
        }
        return mutant;
    }

    private byte[] changed(byte[] text) {
        if (text.length == 0) {
            return nasty();
        }
        int at = random.nextInt(text.length);
        return switch (random.nextInt(8)) {
            case 0 -> flipped(text, at);
            case 1 -> spliced(text, at, new byte[] {(byte) random.nextInt()}, at);
            case 2 -> spliced(text, at, new byte[0], Math.min(text.length, at + 1 + random.nextInt(8)));
            case 3 -> Arrays.copyOf(text, at);
            case 4 -> swapped(text, at, random.nextInt(text.length));
            case 5 -> {
                byte[] other = texts.get(random.nextInt(texts.size()));
                yield spliced(text, at, Arrays.copyOfRange(other, random.nextInt(other.length), other.length), text.length);
            }
            case 6 -> spliced(text, at, nasty(), at);
            default -> spliced(text, wordStart(text, at), nasty(), wordEnd(text, at));
        };
    }

    private byte[] nasty() {
        return NASTY.get(random.nextInt(NASTY.size())).getBytes(StandardCharsets.UTF_8);
    }

    private byte[] flipped(byte[] text, int at) {
        byte[] flipped = text.clone();
        flipped[at] ^= (byte) (1 << random.nextInt(Byte.SIZE));
        return flipped;
    }

    /** Swaps the words at two places. */
    private static byte[] swapped(byte[] text, int one, int other) {
        int first = Math.min(one, other);
        int second = Math.max(one, other);
        int from = wordEnd(text, first);
        int to = wordStart(text, second);
        if (from > to) {
            return text;
        }
        byte[] last = Arrays.copyOfRange(text, wordStart(text, first), from);
        byte[] between = Arrays.copyOfRange(text, from, to);
        byte[] word = Arrays.copyOfRange(text, to, wordEnd(text, second));
        byte[] turned = Arrays.copyOf(word, word.length + between.length + last.length);
        System.arraycopy(between, 0, turned, word.length, between.length);
        System.arraycopy(last, 0, turned, word.length + between.length, last.length);
        return spliced(text, wordStart(text, first), turned, wordEnd(text, second));
    }

    private static byte[] spliced(byte[] text, int from, byte[] middle, int to) {
        byte[] all = new byte[from + middle.length + text.length - to];
        System.arraycopy(text, 0, all, 0, from);
        System.arraycopy(middle, 0, all, from, middle.length);
        System.arraycopy(text, to, all, from + middle.length, text.length - to);
        return all;
    }

    private static int wordStart(byte[] text, int at) {
        int i = at;
        while (i > 0 && text[i - 1] > ' ') {
            i--;
        }
        return i;
    }

    private static int wordEnd(byte[] text, int at) {
        int i = at;
        while (i < text.length && text[i] > ' ') {
            i++;
        }
        return i;
    }
}
