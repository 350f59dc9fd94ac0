package simpleray.render;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.Material;
import simpleray.scene.RayTree;
import simpleray.scene.RayTree.Area;
import simpleray.scene.RayTree.Contribution;
import simpleray.scene.RayTree.Hit;
import simpleray.scene.RayTree.Lamp;
import simpleray.scene.RayTree.Next;
import simpleray.scene.RayTree.Thing;
import simpleray.text.Diagnostic;

/** Writes a pixel's story as text for people: indented lines, each below the line it belongs to. Numbers have six digits. */
public final class StoryText {
    private static final MathContext DIGITS = new MathContext(6);
    private static final int LARGE = 9;
    private static final int SMALL = -6;
    private static final String INDENT = "  ";

    private final List<Line> lines = new ArrayList<>();
    private int level;
    private RayTree ray;                                      // whose lines are written; null before the first
    private Lamp lamp;                                        // likewise; null for none

    /**
     * A line.
     *
     * @param level its depth below the first line, which is at 0
     * @param text its text, not indented
     * @param ray the ray that it tells about; null for the pixel as a whole
     * @param lamp the light at that ray's hit that it tells about; null for none
     */
    public record Line(int level, String text, RayTree ray, Lamp lamp) {
        @Override
        public String toString() {
            return INDENT.repeat(level) + text;
        }
    }

    private StoryText() {
    }

    /**
     * Writes a story.
     *
     * @param pixel the story
     * @return its lines, the first one at level 0 and all others below it
     */
    public static List<Line> lines(PixelStory pixel) {
        StoryText text = new StoryText();
        text.tell(pixel);
        return text.lines;
    }

    /**
     * Writes a story.
     *
     * @param pixel the story
     * @return the lines, indented, each with its line end
     */
    public static String of(PixelStory pixel) {
        return lines(pixel).stream().map(Line::toString).collect(Collectors.joining("\n", "", "\n"));
    }

    /**
     * Names an object or light.
     *
     * @param thing the object or light
     * @return for example "object 3 (sphere, line 12)"
     */
    public static String object(Thing thing) {
        return "object " + named(thing);
    }

    /**
     * Writes a colour.
     *
     * @param c the colour, linear
     * @return red, green and blue with six digits each
     */
    public static String colour(Colour c) {
        return number(c.r) + ' ' + number(c.g) + ' ' + number(c.b);
    }

    /**
     * Writes a colour by the levels of a picture file.
     *
     * @param c the colour, linear
     * @return red, green and blue from 0 to 255
     */
    public static String levels(Colour c) {
        return Picture.level(c.r) + " " + Picture.level(c.g) + ' ' + Picture.level(c.b);
    }

    private static String named(Thing thing) {
        RayTree.Mtl mtl = thing.mtl();
        return thing.number() + " (" + thing.kind() + (thing.line() > 0 ? ", line " + thing.line() : "")
            + (mtl == null ? "" : ", material " + Diagnostic.quoted(mtl.name()) + " of " + Diagnostic.printable(mtl.file()) + ':' + mtl.line()) + ')';
    }

    private void say(String text) {
        lines.add(new Line(level, text, ray, lamp));
    }

    private void tell(PixelStory pixel) {
        say("pixel " + pixel.x() + ',' + pixel.y() + " of " + pixel.width() + 'x' + pixel.height() + ", stage " + pixel.stage() + ": "
            + colour(pixel.colour()) + ", levels " + levels(pixel.colour()) + alpha(pixel));
        level++;
        if (pixel.mean()) {
            long count = pixel.samples().stream().filter(PixelStory.Sample::counts).count();
            say("the mean of " + (count < pixel.samples().size() ? count + " of " : "") + pixel.samples().size()
                + " samples, each brought into 0 to 1");
        }
        for (PixelStory.Sample sample : pixel.samples()) {
            String point = "sample at " + number(sample.px()) + ',' + number(sample.py()) + ": ";
            if (!sample.counts()) {
                say(point + "hits nothing: transparent");
                continue;
            }
            say(point + colour(sample.colour()));
            level++;
            if (pixel.stage().isView()) {
                say("the view " + pixel.stage() + " shows no light; this is the story of stage " + Stage.FINAL);
            }
            tell(sample.tree());
            level--;
        }
        level--;
    }

    private static String alpha(PixelStory pixel) {
        if (pixel.alpha().isEmpty()) {
            return "";
        }
        double alpha = pixel.alpha().getAsDouble();
        return alpha == 0 ? ", transparent" : ", alpha " + number(alpha) + ", level " + Picture.level(alpha);
    }

    private void tell(RayTree story) {
        RayTree outer = ray;
        ray = story;
        say("ray from " + point(story.ray().origin) + " along " + vector(story.ray().direction) + ", depth " + story.depth() + ": "
            + colour(story.colour()));
        level++;
        if (!story.told()) {
            say("not told any more: the pixel has too many rays");
        } else if (story.hit() == null) {
            say("hits nothing: background " + colour(story.colour()));
        } else {
            tell(story.hit());
            say("sum: " + colour(story.colour()));
        }
        level--;
        ray = outer;
    }

    private void tell(Hit hit) {
        Material material = hit.material();
        say("hits " + object(hit.object()) + " at distance " + number(hit.distance()));
        level++;
        say("point " + point(hit.point()) + ", normal " + vector(hit.normal()) + (hit.enters() ? ", going in" : ", going out"));
        level--;
        say("ambient: " + colour(hit.ambient()));
        level++;
        say("Ka " + colour(material.ambient) + ", GA " + colour(hit.light()));
        level--;
        for (Contribution light : hit.lamps()) {
            lamp = light instanceof Lamp one ? one : null;
            say("light " + named(light.light()) + ": " + both(light));
            level++;
            if (light instanceof Area area) {
                tell(area, material);
            } else {
                tell((Lamp) light, material);
            }
            level--;
            lamp = null;
        }
        say("diffuse of all lights: " + colour(hit.diffuse()));
        say("specular of all lights: " + colour(hit.specular()));
        tell(hit.mirror(), "mirror ray", material.mirror == null ? "Ks" : "mirror");
        tell(hit.refracted(), "refracted ray", "Kt");
    }

    private static String both(Contribution light) {
        return colour(Colour.add(light.diffuse(), light.specular()));
    }

    private void tell(Area area, Material material) {
        say("of its " + area.points() + " points: " + area.whole()
            + (area.shadows() ? " reach the point" : " shine, for this stage has no shadows")
            + some(area.dimmed(), "reach it dimmed") + some(area.blocked(), "blocked") + some(area.turnedAway(), "behind the surface"));
        if (area.between() == null) {
            say("too much is between to be told");
        } else if (!area.between().isEmpty()) {
            say("between: " + area.between().stream().map(StoryText::object).collect(Collectors.joining(", ")));
        }
        say("LC " + colour(area.intensity()) + ", of each point " + colour(Colour.scale(area.intensity(), 1.0 / area.points())));
        say("diffuse " + colour(area.diffuse()) + ", Kd " + colour(material.diffuse));
        say("specular " + colour(area.specular()) + ", Ks " + colour(material.specular) + ", shininess " + number(material.shininess));
        if (area.lamps() == null) {
            say("its points are not told any more: the pixel has too many of them");
            return;
        }
        for (int i = 0; i < area.lamps().size(); i++) {
            say("point " + (i + 1) + ": " + both(area.lamps().get(i)));
            level++;
            tell(area.lamps().get(i), material);
            level--;
        }
    }

    private static String some(int number, String what) {
        return number == 0 ? "" : ", " + number + ' ' + what;
    }

    private void tell(Lamp lamp, Material material) {
        say(switch (lamp.verdict()) {
            case TURNED_AWAY -> "the surface is turned away from it";
            case NO_SHADOWS -> "shines, for this stage has no shadows";
            case REACHES -> "reaches the point";
            case DIMMED -> "reaches the point, dimmed by " + between(lamp) + " to " + colour(lamp.arriving());
            case BLOCKED -> "blocked by " + between(lamp);
        });
        say("LC " + colour(lamp.intensity()) + (Double.isInfinite(lamp.distance()) ? "" : ", distance " + number(lamp.distance())));
        say("L " + vector(lamp.towards()) + ", N.L " + number(lamp.facing()));
        say("H " + vector(lamp.halfway()) + ", N.H " + number(lamp.cosine()));
        say("diffuse " + colour(lamp.diffuse()) + ", Kd " + colour(material.diffuse));
        say("specular " + colour(lamp.specular()) + ", Ks " + colour(material.specular) + ", shininess " + number(material.shininess));
    }

    private static String between(Lamp lamp) {
        return lamp.between().stream()
            .map(b -> object(b.object()) + (b.transmission().isBlack() ? "" : " with Kt " + colour(b.transmission())))
            .collect(Collectors.joining(" and "));
    }

    private void tell(Next next, String what, String share) {
        if (next != null) {
            say(what + ": " + colour(next.colour()) + ", " + share + ' ' + colour(next.share()));
            level++;
            tell(next.tree());
            level--;
        }
    }

    static String point(Point p) {
        return '(' + number(p.x) + ' ' + number(p.y) + ' ' + number(p.z) + ')';
    }

    private static String vector(Vector v) {
        return '(' + number(v.x) + ' ' + number(v.y) + ' ' + number(v.z) + ')';
    }

    /** {@return a number of six digits, the same on every Java} */
    private static String number(double d) {
        if (d == 0 || Double.isNaN(d) || Double.isInfinite(d)) {
            return d == 0 ? "0" : Double.toString(d);
        }
        BigDecimal rounded = new BigDecimal(d).round(DIGITS).stripTrailingZeros();
        int exponent = rounded.precision() - rounded.scale() - 1;
        return exponent > LARGE || exponent < SMALL ? rounded.toString() : rounded.toPlainString();
    }
}
