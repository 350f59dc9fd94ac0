package simpleray.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * What a thing of a film is at one frame. <em>Constant.</em>
 *
 * @param frame the frame, 0 or more; need not be whole
 * @param thing the thing
 * @param values as many numbers as its kind has channels
 */
public record Key(double frame, Thing thing, List<Double> values) {
    /**
     * Makes a key. A frame of -0.0 is 0.0.
     *
     * @param frame the frame, 0 or more; need not be whole
     * @param thing the thing
     * @param values as many numbers as its kind has channels
     */
    public Key {
        frame += 0.0;
        values = List.copyOf(values);
        if (values.size() != thing.kind.channels) {
            throw new IllegalArgumentException("a key of " + thing + " has " + thing.kind.channels + " values, not " + values.size());
        }
    }

    /** What a key can be of. */
    public enum Kind {
        /** The camera: eye, look-at point and field of view. */
        CAMERA(7),
        /** An object: how far it is moved from its place in the file. */
        OBJECT(3),
        /** A light: how far it is moved. */
        LIGHT(3),
        /** A light's colour. */
        COLOUR(3);

        /** The numbers that a key of this kind has. */
        final int channels;
        private final String word = name().toLowerCase(Locale.ROOT);

        Kind(int channels) {
            this.channels = channels;
        }

        /** {@return its word in a scene file} */
        @Override
        public String toString() {
            return word;
        }
    }

    /**
     * What keys are of. <em>Constant.</em>
     *
     * @param kind its kind
     * @param number the object's or light's number, from 1; 0 for the camera
     */
    public record Thing(Kind kind, int number) {
        /** {@return such as {@code camera} or {@code object 3}} */
        @Override
        public String toString() {
            return number == 0 ? kind.toString() : kind.toString() + ' ' + number;
        }
    }

    /** {@return its words in a scene file} */
    List<java.lang.Object> words() {
        List<java.lang.Object> words = new ArrayList<>(List.of(frame, thing.kind.toString()));
        if (thing.number > 0) {
            words.add(thing.number);
        }
        words.addAll(values);
        return words;
    }
}
