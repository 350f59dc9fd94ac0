package simpleray.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The values of a scene file, as a {@link SceneReader} that was {@linkplain SceneReader#list asked to} has read them. <em>Mutable.</em> */
public final class SourceValues {
    private final List<SourceValue> all = new ArrayList<>();
    private final Map<String, String> names = new HashMap<>();        // each once: a scene has a million "centre y"

    /** Creates an empty list. */
    public SourceValues() {
    }

    /** {@return the values, in the order of the file; those before the first error after which the rest could not be read} */
    public List<SourceValue> all() {
        return all;
    }

    void add(SourceSpan span, SourceValue.Thing thing, String name, SourceValue.Type type) {
        all.add(new SourceValue(span, thing, names.computeIfAbsent(name, same -> same), type));
    }

    /** Gives the value read last to a thing, whose kind it tells. */
    void give(SourceValue.Thing thing, String name) {
        SourceValue last = all.remove(all.size() - 1);
        all.add(new SourceValue(last.span(), thing, name, last.type()));
    }
}
