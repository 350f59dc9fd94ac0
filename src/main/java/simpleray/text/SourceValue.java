package simpleray.text;

/**
 * A value of a scene file: where it is, and what it is in the words of the class that read it. <em>Constant.</em>
 *
 * @param span where it is
 * @param thing the object or light that it belongs to; null if it belongs to none
 * @param name what it is, without the thing: "centre y"
 * @param type which values may stand there
 */
public record SourceValue(SourceSpan span, Thing thing, String name, Type type) {
    /** What values may stand in a place. */
    public enum Type {
        /** Any number, within limits that the reader knows. */
        NUMBER,
        /** Integers. */
        INTEGER,
        /** Words. */
        WORD
    }

    /**
     * One of a list of things. <em>Constant.</em>
     *
     * @param what what the list is of: "object"
     * @param number its number, from 1
     * @param count how many there are
     * @param kind its kind: "sphere"
     */
    public record Thing(String what, int number, int count, String kind) {
    }

    /** {@return the whole name: "object 7 of 9, sphere: centre y"} */
    @Override
    public String toString() {
        return thing == null ? name : thing.what + ' ' + thing.number + " of " + thing.count + ", " + thing.kind + ": " + name;
    }
}
