package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumMap;
import java.util.TreeSet;
import simpleray.math.Colour;
import simpleray.scene.RayTree;
import simpleray.scene.RayTree.Area;
import simpleray.scene.RayTree.Between;
import simpleray.scene.RayTree.Contribution;
import simpleray.scene.RayTree.Hit;
import simpleray.scene.RayTree.Lamp;
import simpleray.scene.RayTree.Next;
import simpleray.scene.RayTree.Verdict;

/** Adds the terms of stories anew, from the stories alone, and compares the sums with those in the stories, bit for bit. */
final class StorySums {
    /** The number of rays that hit an object. */
    int hits;
    /** The number of area lights at these hits. */
    int areas;
    /** The numbers of blocked and of dimmed lights. */
    int blocked;
    int dimmed;
    /** The numbers of mirror rays and of refracted rays. */
    int mirrored;
    int refracted;

    void check(RayTree story, String where) {
        if (story.hit() == null) {
            return;
        }
        hits++;
        Hit hit = story.hit();
        assertSame(where, hit.ambient(), Colour.mult(hit.material().ambient, hit.light()));
        Colour diffuse = new Colour();
        Colour specular = new Colour();
        for (Contribution light : hit.lamps()) {
            if (light instanceof Area area) {
                check(area, hit, where);
            } else {
                check((Lamp) light, hit, where);
            }
            diffuse.add(light.diffuse());
            specular.add(light.specular());
        }
        assertSame(where, hit.diffuse(), diffuse);
        assertSame(where, hit.specular(), specular);
        Colour sum = new Colour(hit.ambient());
        sum.add(diffuse);
        sum.add(specular);
        mirrored += add(sum, hit.mirror(), where);
        refracted += add(sum, hit.refracted(), where);
        assertSame(where, story.colour(), sum);
    }

    private int add(Colour sum, Next next, String where) {
        if (next == null) {
            return 0;
        }
        assertSame(where, next.colour(), Colour.mult(next.tree().colour(), next.share()));
        sum.add(next.colour());
        check(next.tree(), where);
        return 1;
    }

    private void check(Area area, Hit hit, String where) {
        areas++;
        assertThat(area.turnedAway()).as(where).isNotNegative();
        assertThat(area.between().isEmpty()).as(where).isEqualTo(area.dimmed() + area.blocked() == 0);
        if (area.lamps().isEmpty()) {
            return;
        }
        assertThat(area.lamps()).as(where).hasSize(area.points());
        Colour diffuse = new Colour();
        Colour specular = new Colour();
        EnumMap<Verdict, Integer> verdicts = new EnumMap<>(Verdict.class);
        TreeSet<Integer> between = new TreeSet<>();
        for (Lamp lamp : area.lamps()) {
            check(lamp, hit, where);
            diffuse.add(lamp.diffuse());
            specular.add(lamp.specular());
            verdicts.merge(lamp.verdict(), 1, Integer::sum);
            lamp.between().forEach(object -> between.add(object.object().number()));
        }
        assertSame(where, area.diffuse(), diffuse);
        assertSame(where, area.specular(), specular);
        assertThat(area.whole()).as(where).isEqualTo(verdicts.getOrDefault(Verdict.REACHES, 0));
        assertThat(area.dimmed()).as(where).isEqualTo(verdicts.getOrDefault(Verdict.DIMMED, 0));
        assertThat(area.blocked()).as(where).isEqualTo(verdicts.getOrDefault(Verdict.BLOCKED, 0));
        assertThat(area.between().stream().map(RayTree.Thing::number)).as(where).containsExactlyElementsOf(between);
    }

    private void check(Lamp lamp, Hit hit, String where) {
        Colour arriving = new Colour();
        if (lamp.verdict() == Verdict.TURNED_AWAY) {
            assertThat(lamp.facing()).as(where).isLessThanOrEqualTo(0);
        } else {
            assertThat(lamp.facing()).as(where).isGreaterThan(0);
            arriving.copy(lamp.intensity());
            for (Between between : lamp.between()) {
                arriving.mult(between.transmission());
            }
        }
        assertSame(where, lamp.arriving(), arriving);
        Colour diffuse = Colour.mult(hit.material().diffuse, arriving);
        diffuse.scale(Math.max(0, lamp.facing()));
        assertSame(where, lamp.diffuse(), diffuse);
        assertThat(lamp.verdict() == Verdict.REACHES).as(where)
            .isEqualTo(lamp.between().isEmpty() && lamp.verdict() != Verdict.TURNED_AWAY);
        if (lamp.verdict() == Verdict.BLOCKED) {
            blocked++;
            assertThat(arriving.isBlack()).as(where).isTrue();
        } else if (lamp.verdict() == Verdict.DIMMED) {
            dimmed++;
            assertThat(lamp.between()).as(where).noneMatch(between -> between.transmission().isBlack());
        }
    }

    static void assertSame(String where, Colour actual, Colour expected) {
        assertThat(bits(actual)).as(where).isEqualTo(bits(expected));
    }

    private static String bits(Colour c) {                    // 0 and -0 are one
        return Double.toHexString(c.r + 0.0) + ' ' + Double.toHexString(c.g + 0.0) + ' ' + Double.toHexString(c.b + 0.0);
    }
}
