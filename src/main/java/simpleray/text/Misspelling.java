package simpleray.text;

import java.util.Collection;
import java.util.Locale;

/** Guesses what was meant by a misspelt word, by the edit distance (Levenshtein 1966). */
public final class Misspelling {
    private static final int SHORT = 3;

    private Misspelling() {
    }

    /**
     * Finds the known word that differs least from another.
     *
     * @param word the other word, in any case
     * @param known the known words, in lower case
     * @return one that at most two letters tell apart, or one if the word has three or fewer; null if there is none
     */
    public static String meant(String word, Collection<String> known) {
        String meant = null;
        int least = word.length() <= SHORT ? 2 : SHORT;
        for (String one : known) {
            int distance = distance(word.toLowerCase(Locale.ROOT), one);
            if (distance < least) {
                least = distance;
                meant = one;
            }
        }
        return meant;
    }

    /** {@return how many letters are to be put in, taken out or changed to make one word of the other} */
    private static int distance(String a, String b) {
        int[] row = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            row[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int changed = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(changed, Math.min(row[j], row[j - 1]) + 1);
            }
        }
        return row[b.length()];
    }
}
