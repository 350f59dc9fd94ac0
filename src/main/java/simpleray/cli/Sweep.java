package simpleray.cli;

import java.util.List;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import simpleray.text.NumberParser;

/**
 * The values of the shininess, one after another.
 *
 * @param values the numbers as they were written, each 0 or more; at least one
 */
record Sweep(List<String> values) {
    /** Reads {@code shininess=2,5,20,100}. */
    static final class Converter implements ITypeConverter<Sweep> {
        private static final String NAME = "shininess=";

        @Override
        public Sweep convert(String value) {
            if (!value.startsWith(NAME)) {
                throw new TypeConversionException("only the shininess can be swept: expected shininess=2,5,20,100 or the like, found '"
                    + value + "'");
            }
            List<String> words = List.of(value.substring(NAME.length()).split(",", -1));
            for (String word : words) {
                double number = NumberParser.parseDouble(word);
                if (Double.isNaN(number) || number < 0) {
                    throw new TypeConversionException("expected numbers of 0 or more such as shininess=2,5,20,100, found '" + word
                        + (words.size() > 1 ? "' in '" + value : "") + "'");
                }
            }
            return new Sweep(words);
        }
    }
}
