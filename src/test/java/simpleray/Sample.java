package simpleray;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/**
 * How much the long tests try: everything by {@code ./check --all}, which sets the system property {@code simpleray.all}, and else a small
 * sample, the same one each time. What no sample makes short is tagged {@code slow} and left out. PIT, which runs each test thousands of
 * times, sets {@code simpleray.least} and has a quarter of the sample.
 */
public final class Sample {
    private static final boolean ALL = Boolean.getBoolean("simpleray.all");
    private static final boolean FOR_PIT = Boolean.getBoolean("simpleray.least");
    private static final int PIT_SHARE = 4;
    private static final long SEED = 20261129;

    private Sample() {
    }

    /** {@return how many are to be tried: all or a few, and at least one} */
    public static int size(int all, int few) {
        return ALL ? all : FOR_PIT ? Math.max(1, few / PIT_SHARE) : few;
    }

    /** {@return what is to be tried: all, or a few at random} */
    public static <T> List<T> of(List<T> all, int few) {
        List<T> some = new ArrayList<>(all);
        Collections.shuffle(some, new Random(SEED));
        return ALL ? all : some.subList(0, Math.min(size(all.size(), few), all.size()));
    }
}
