package simpleray.rays;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.render.PixelStory;
import simpleray.render.Stage;
import simpleray.scene.Camera;
import simpleray.scene.Material;
import simpleray.scene.RayTree;
import simpleray.scene.RayTree.Area;
import simpleray.scene.RayTree.Between;
import simpleray.scene.RayTree.Contribution;
import simpleray.scene.RayTree.Hit;
import simpleray.scene.RayTree.Lamp;
import simpleray.scene.RayTree.Next;
import simpleray.scene.RayTree.Thing;
import simpleray.scene.RayTree.Verdict;
import simpleray.scene.Scene;
import simpleray.scene.Terms;
import simpleray.text.Diagnostic;
import simpleray.text.RoundedDecimal;
import simpleray.text.ShortestDecimal;

/**
 * Tells a pixel's story to people, as the command line and the window show it: for each ray a sentence, below it the sum of its colour, and
 * each term as formula, numbers and result. All numbers are recorded ones, shown with three digits; all their digits are in the tips.
 */
public final class StoryText {
    /** How many digits numbers have. */
    private static final int DIGITS = 3;
    /** How many digits places in a picture have, and colours in its status line. */
    private static final int FINE = 6;
    /** The most groups of hidden lights whose blockers a sentence names. */
    private static final int MAX_GROUPS = 3;
    /** A term below this, a thousandth of a level, is left out of a sum; a light whose N.L is below it grazes the surface. */
    private static final double MIN_TERM = 4e-6;
    private static final String INDENT = "  ";
    private static final String TIMES = " · ";
    private static final String KD = "Kd, the share of a light that the surface scatters evenly";
    private static final String KS = "Ks, the share of a light in the surface's highlight";
    private static final String LC = "LC, the light's colour";
    private static final String ARRIVING = "what arrives of the light's colour";
    private static final String FACING = "N·L, the cosine of the angle between the normal N and the way L to the light";
    private static final String HIGHLIGHT =
        "N·H, the cosine of the angle between the normal N and the halfway vector H, or 0 if that is less";
    private static final Map<String, String> SHARES = Map.of("Ks", KS + " and of the mirror ray",
        "mirror", "mirror, the share of the mirror ray",
        "(Ks + Kt)", "all that is reflected and would pass through", "(mirror + Kt)", "all that is reflected and would pass through",
        "Kt", "Kt, the share of light that passes through");
    private static final String SHININESS = "shininess, the exponent: the larger, the smaller the highlight";

    private final ObjectNames names;
    private final Terms terms;
    private final List<Line> lines = new ArrayList<>();
    private List<Part> parts = new ArrayList<>();             // of the line that is being written
    private int level;
    private Supplier<List<Line>> more;                        // of that line; null if nothing
    private RayTree ray;                                      // whose lines are written; null before the first
    private Lamp lamp;                                        // likewise; null for none

    /**
     * A part of a line.
     *
     * @param text its text
     * @param meaning tells what it means, with all digits of its numbers; null where there is nothing to be explained
     * @param swatch the colour that it tells; null unless it is the result or a term of a sum
     * @param source the line of the scene's text that it names; 0 for none
     */
    public record Part(String text, Supplier<String> meaning, Colour swatch, int source) {
        /** {@return what it means; null where there is nothing to be explained} Takes a while: all digits of a number are looked for. */
        public String tip() {
            return meaning == null ? null : meaning.get();
        }
    }

    /**
     * A line.
     *
     * @param level its depth below the first line, which is at 0
     * @param parts its parts, from left to right
     * @param ray the ray that it tells about; null for the pixel as a whole
     * @param lamp the light at that ray's hit, or the point of an area light, that it tells about; null for none
     * @param more tells the lines below it, for those of an outline that has them not yet; null if all are told
     */
    public record Line(int level, List<Part> parts, RayTree ray, Lamp lamp, Supplier<List<Line>> more) {
        /** {@return its text, not indented} */
        public String text() {
            return parts.stream().map(Part::text).collect(Collectors.joining());
        }

        @Override
        public String toString() {
            return INDENT.repeat(level) + text();
        }
    }

    private StoryText(Terms terms, ObjectNames names) {
        this.terms = terms;
        this.names = names;
    }

    /**
     * Tells a story.
     *
     * @param pixel the story
     * @param scene its scene
     * @param camera the camera of its picture
     * @return its lines, the first one at level 0 and all others below it
     */
    public static List<Line> lines(PixelStory pixel, Scene scene, Camera camera) {
        return lines(pixel, scene, camera, false);
    }

    /**
     * Tells a story, but of several samples only that in the middle: of hundreds, nobody reads all.
     *
     * @param pixel the story
     * @param scene its scene
     * @param camera the camera of its picture
     * @return its lines, the first one at level 0 and all others below it
     */
    public static List<Line> outline(PixelStory pixel, Scene scene, Camera camera) {
        return lines(pixel, scene, camera, true);
    }

    private static List<Line> lines(PixelStory pixel, Scene scene, Camera camera, boolean outline) {
        StoryText text = new StoryText(pixel.stage().terms(), new ObjectNames(scene, camera));
        text.tell(pixel, outline);
        return text.lines;
    }

    /**
     * Tells a story.
     *
     * @param pixel the story
     * @param scene its scene
     * @param camera the camera of its picture
     * @return the lines, indented, each with its line end
     */
    public static String of(PixelStory pixel, Scene scene, Camera camera) {
        return lines(pixel, scene, camera).stream().map(Line::toString).collect(Collectors.joining("\n", "", "\n"));
    }

    /**
     * Names an object as messages do.
     *
     * @param thing the object
     * @return for example "object 3 (sphere, line 12)"
     */
    public static String object(Thing thing) {
        return "object " + thing.number() + " (" + thing.kind() + (thing.line() > 0 ? ", line " + thing.line() : "")
            + (thing.mtl() == null ? "" : ", " + material(thing.mtl())) + ')';
    }

    /**
     * Writes a colour.
     *
     * @param c the colour, linear
     * @return red, green and blue with six digits each
     */
    public static String colour(Colour c) {
        return colour(c, FINE);
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

    private static String material(RayTree.Mtl mtl) {
        return "material " + Diagnostic.quoted(mtl.name()) + " of " + Diagnostic.printable(mtl.file()) + ':' + mtl.line();
    }

    private static String colour(Colour c, int digits) {
        return RoundedDecimal.of(c.r, c.g, c.b, digits);
    }

    private static String number(double d) {
        return RoundedDecimal.of(d, DIGITS);
    }

    private static String exact(Colour c) {
        return exact(c.r, c.g, c.b);
    }

    private static String exact(double a, double b, double c) {
        return ShortestDecimal.of(a) + ' ' + ShortestDecimal.of(b) + ' ' + ShortestDecimal.of(c);
    }

    private StoryText say(String text) {
        parts.add(new Part(text, null, null, 0));
        return this;
    }

    private StoryText say(String text, String meaning) {
        return say(text, () -> meaning);
    }

    private StoryText say(String text, Supplier<String> meaning) {
        parts.add(new Part(text, meaning, null, 0));
        return this;
    }

    private StoryText sayNumber(String text, String meaning, double d) {
        return say(text, () -> meaning + ": " + ShortestDecimal.of(d));
    }

    /** A colour as a result or a term of a sum, after its name. */
    private StoryText sayColour(String name, Colour c) {
        parts.add(new Part((name.isEmpty() ? "" : name + ' ') + colour(c, DIGITS), () -> exact(c), c, 0));
        return this;
    }

    /** A colour as a factor. */
    private StoryText sayFactor(Colour c, String meaning) {
        return say('(' + colour(c, DIGITS) + ')', () -> meaning + ": " + exact(c));
    }

    private StoryText sayCosine(double cosine, String meaning) {
        return say(number(cosine), () -> meaning + ": " + ShortestDecimal.of(cosine) + ", "
            + String.format(Locale.ROOT, "%.1f°", StrictMath.toDegrees(StrictMath.acos(Math.max(-1, Math.min(1, cosine))))));
    }

    private StoryText sayTriple(double a, double b, double c, String meaning) {
        return say('(' + RoundedDecimal.of(a, b, c, DIGITS) + ')', () -> meaning + ": " + exact(a, b, c));
    }

    private StoryText sayVector(Vector v, String meaning) {
        return sayTriple(v.x, v.y, v.z, meaning);
    }

    private StoryText sayPoint(Point p, String meaning) {
        return sayTriple(p.x, p.y, p.z, meaning);
    }

    private StoryText sayObject(Thing thing, Material material) {
        String name = names.of(thing, material);
        boolean begins = parts.isEmpty();
        say(begins ? name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1) : name);
        return sayPlace(thing, "object");
    }

    /** Where an object or light stands in the scene's text; its number if it is from no file. */
    private StoryText sayPlace(Thing thing, String what) {
        String number = what + ' ' + thing.number();
        if (thing.line() == 0) {
            return what.equals("light") ? this : say(" (" + number + ')');
        }
        say(" (");
        parts.add(new Part("line " + thing.line(), () -> number + " of the scene, a " + thing.kind(), null, thing.line()));
        return say(thing.mtl() == null ? ")" : ", " + material(thing.mtl()) + ')');
    }

    private StoryText sayObjects(List<Thing> things) {
        for (int i = 0; i < things.size(); i++) {
            say(i == 0 ? "the " : i == things.size() - 1 ? " and the " : ", the ").sayObject(things.get(i), null);
        }
        return this;
    }

    private void end() {
        lines.add(new Line(level, List.copyOf(parts), ray, lamp, more));
        parts = new ArrayList<>();
        more = null;
    }

    private void tell(PixelStory pixel, boolean outline) {
        say("pixel " + pixel.x() + ',' + pixel.y() + " of " + pixel.width() + 'x' + pixel.height() + ", stage " + pixel.stage() + ": ")
            .sayColour("", pixel.colour()).say(", levels " + levels(pixel.colour()) + alpha(pixel)).end();
        level++;
        if (pixel.stage().isView()) {
            say("the view " + pixel.stage() + " shows no light; this is the story of stage " + Stage.FINAL).end();
        }
        if (pixel.mean()) {
            long count = pixel.samples().stream().filter(PixelStory.Sample::counts).count();
            say("the mean of " + (count < pixel.samples().size() ? count + " of " : "") + pixel.samples().size()
                + " samples, each brought into 0 to 1").end();
        }
        for (int i = 0; i < pixel.samples().size(); i++) {
            PixelStory.Sample sample = pixel.samples().get(i);
            boolean later = outline && i != pixel.samples().size() / 2;
            if (pixel.mean()) {
                say("sample at " + RoundedDecimal.of(sample.px(), FINE) + ',' + RoundedDecimal.of(sample.py(), FINE) + ": ");
                more = later ? () -> below(sample) : null;
                (sample.counts() ? sayColour("", sample.colour()) : say("hits nothing: transparent")).end();
            }
            if (!later) {
                tellSample(sample, pixel.mean() ? level + 1 : level);
            }
        }
        level--;
    }

    private void tellSample(PixelStory.Sample sample, int at) {
        int outer = level;
        level = at;
        tell(sample.tree(), "", null, null);
        level = outer;
    }

    private List<Line> below(PixelStory.Sample sample) {
        StoryText text = new StoryText(terms, names);
        text.tellSample(sample, 2);
        return text.lines;
    }

    private static String alpha(PixelStory pixel) {
        if (pixel.alpha().isEmpty()) {
            return "";
        }
        double alpha = pixel.alpha().getAsDouble();
        return alpha == 0 ? ", transparent" : ", alpha " + number(alpha) + ", level " + Picture.level(alpha);
    }

    /** Tells a ray: what it is (nothing for the primary one), what it hits, and what share of its colour counts, by its symbol (null for all). */
    private void tell(RayTree story, String what, Next next, String share) {
        RayTree outer = ray;
        ray = story;
        if (!what.isEmpty()) {
            say(what);
        }
        Hit hit = story.hit();
        if (!story.told()) {
            say(what.isEmpty() ? "Not told any more" : "not told any more").say(", for the pixel has too many rays: ")
                .sayColour("", story.colour()).end();
        } else if (hit == null) {
            say(what.isEmpty() ? "Nothing is hit" : "nothing is hit");
            (story.colour().isBlack() ? say(".") : say(": ").sayColour("background", story.colour())).end();
        } else {
            tellSentence(story);
        }
        level++;
        if (next != null) {
            say((share.equals("Kt") ? "refracted" : "mirror") + " = ").say(share, SHARES.get(share)).say(TIMES + "C = ")
                .sayFactor(next.share(), share).say(TIMES).sayFactor(story.colour(), "C, the colour that this ray sees").say(" = ")
                .sayColour("", next.colour()).end();
        }
        if (hit != null) {
            tellTerms(story);
        }
        say("ray from ").sayPoint(story.ray().origin, "its origin")
            .say(" along ").sayVector(story.ray().direction, "its direction, of length 1")
            .say(", depth " + story.depth(), "how many reflections and refractions may follow");
        if (hit != null) {
            say(": ").sayNumber("t = " + number(hit.distance()), "t, the distance", hit.distance())
                .say(", P = ").sayPoint(hit.point(), "P, the point that is hit")
                .say(", N = ").sayVector(hit.normal(), "N, the normal there, turned to where the ray comes from")
                .say(hit.enters() ? ", going in" : ", going out");
        }
        end();
        if (hit != null) {
            tellNext(story);
        }
        level--;
        ray = outer;
    }

    private void tellSentence(RayTree story) {
        Hit hit = story.hit();
        Thing object = hit.object();
        if (!hit.enters() && !hit.material().transmission.isBlack() && names.isBody(object)) {
            say(parts.isEmpty() ? "Inside of the " : "the inside of the ");
        }
        sayObject(object, hit.material());
        if (terms.lights()) {
            tellLights(hit.lamps());
        } else {
            say("; this stage shows no lights");
        }
        if (hit.mirror() != null) {
            say("; ").say(isTotal(hit) ? "it reflects all light inward and shows " : "it mirrors ").saySeen(hit.mirror(), object);
        }
        if (hit.refracted() != null) {
            say("; ").say("through it one sees ").saySeen(hit.refracted(), object);
        }
        say(".").end();
    }

    private static boolean isTotal(Hit hit) {
        return hit.refracted() == null && !hit.material().transmission.isBlack();
    }

    private void saySeen(Next next, Thing from) {
        Hit hit = next.tree().hit();
        if (hit == null) {
            say(next.tree().told() ? "the background" : "more than is told");
        } else if (hit.object().number() == from.number() && !hit.enters() && names.isBody(from)) {
            say("its own inside");
        } else {
            say("the ").sayObject(hit.object(), hit.material());
        }
    }

    /** Tells which lights reach the point, and which not. */
    private void tellLights(List<Contribution> lights) {
        String before = ", ";
        List<Integer> whole = new ArrayList<>();
        List<Integer> grazing = new ArrayList<>();
        List<Integer> away = new ArrayList<>();
        Map<List<Thing>, List<Integer>> dimmed = new LinkedHashMap<>();
        Map<List<Thing>, List<Integer>> blocked = new LinkedHashMap<>();
        List<Area> partly = new ArrayList<>();
        for (Contribution light : lights) {
            int number = light.light().number();
            if (light instanceof Area area) {
                List<Thing> between = area.between() == null ? List.of() : area.between();
                if (area.whole() == area.points()) {
                    whole.add(number);
                } else if (area.turnedAway() == area.points()) {
                    away.add(number);
                } else if (area.whole() + area.dimmed() == 0) {
                    blocked.computeIfAbsent(between, b -> new ArrayList<>()).add(number);
                } else {
                    partly.add(area);
                }
            } else {
                Lamp one = (Lamp) light;
                switch (one.verdict()) {
                    case REACHES, NO_SHADOWS -> (one.facing() < MIN_TERM ? grazing : whole).add(number);
                    case TURNED_AWAY -> away.add(number);
                    case DIMMED -> dimmed.computeIfAbsent(between(one), b -> new ArrayList<>()).add(number);
                    case BLOCKED -> blocked.computeIfAbsent(between(one), b -> new ArrayList<>()).add(number);
                    default -> throw new IllegalStateException(one.verdict().toString());
                }
            }
        }
        if (!whole.isEmpty()) {
            say(before + "lit by " + lights(whole));
            before = "; ";
        }
        for (Map.Entry<List<Thing>, List<Integer>> entry : dimmed.entrySet()) {
            say(before + "lit by " + lights(entry.getValue()) + " through ").sayObjects(entry.getKey());
            before = "; ";
        }
        for (Area area : partly) {
            int arriving = area.whole() + area.dimmed();
            say(before + "lit by " + arriving + " of the " + area.points() + " points of light " + area.light().number());
            before = "; ";
        }
        if (!grazing.isEmpty()) {
            say(before + "grazed by " + lights(grazing));
            before = "; ";
        }
        if (!away.isEmpty()) {
            say(before + "turned away from " + lights(away));
            before = "; ";
        }
        int group = 0;
        for (Map.Entry<List<Thing>, List<Integer>> entry : blocked.entrySet()) {
            boolean named = group++ < MAX_GROUPS && !entry.getKey().isEmpty();
            say("; " + lights(entry.getValue()) + (entry.getValue().size() == 1 ? " is" : " are") + " hidden" + (named ? " by " : ""));
            if (named) {
                sayObjects(entry.getKey());
            }
        }
    }

    private static String lights(List<Integer> numbers) {
        int last = numbers.size() - 1;
        return last == 0 ? "light " + numbers.get(0) : "lights " + numbers.subList(0, last).stream().map(String::valueOf)
            .collect(Collectors.joining(", ")) + " and " + numbers.get(last);
    }

    /** {@return the objects that dim a light, or the one that blocks it; all of them if only together they do} */
    private static List<Thing> between(Lamp one) {
        List<Between> all = one.between();
        boolean last = one.verdict() == Verdict.BLOCKED && all.get(all.size() - 1).transmission().isBlack();
        return all.subList(last ? all.size() - 1 : 0, all.size()).stream().map(Between::object).toList();
    }

    private void tellTerms(RayTree story) {
        Hit hit = story.hit();
        sayColour("", story.colour());
        String before = " = ";
        before = addTerm(before, "ambient", hit.ambient());
        for (Contribution light : hit.lamps()) {
            before = addTerm(before, "light " + light.light().number(), both(light));
        }
        before = hit.mirror() == null ? before : addTerm(before, "mirror", hit.mirror().colour());
        before = hit.refracted() == null ? before : addTerm(before, "refracted", hit.refracted().colour());
        if (before.equals(" = ")) {
            say(": next to no light comes from here");
        }
        end();

        Material material = hit.material();
        if (terms.ambient() && !isNone("ambient", "Ka", material.ambient)) {
            say("ambient = ").say("Ka", "Ka, the share of the ambient light that the surface reflects").say(TIMES)
                .say("GA", "GA, the ambient light of the scene").say(" = ").sayFactor(material.ambient, "Ka").say(TIMES)
                .sayFactor(hit.light(), "GA").say(" = ").sayColour("", hit.ambient()).end();
        }
        for (Contribution light : terms.lights() ? hit.lamps() : List.<Contribution>of()) {
            say("light " + light.light().number()).sayPlace(light.light(), "light");
            if (light instanceof Area area) {
                tell(area, material);
            } else {
                tell((Lamp) light, material);
            }
        }
    }

    private String addTerm(String before, String name, Colour c) {
        if (Math.max(c.r, Math.max(c.g, c.b)) < MIN_TERM) {
            return before;
        }
        say(before).sayColour(name, c);
        return " + ";
    }

    /** {@return whether a term is none, since its share is black} If so, that is the line. */
    private boolean isNone(String term, String share, Colour c) {
        if (c.isBlack()) {
            say(term + " = 0, for " + share + " is black").end();
        }
        return c.isBlack();
    }

    private static Colour both(Contribution light) {
        return Colour.add(light.diffuse(), light.specular());
    }

    /** Tells an area light, whose line is begun. */
    private void tell(Area area, Material material) {
        say(": of its " + area.points() + " points " + area.whole()
            + (area.shadows() ? " seen from here" : " shining, for this stage has no shadows")
            + some(area.dimmed(), "dimmed") + some(area.blocked(), "hidden") + some(area.turnedAway(), "behind the surface")
            + ": ").sayColour("", both(area)).end();
        level++;
        if (area.between() == null) {
            say("too much is between to be told").end();
        } else if (!area.between().isEmpty()) {
            say("between: ").sayObjects(area.between()).end();
        }
        int count = area.points();
        String each = LC + " / the number of its points";
        Colour share = Colour.scale(area.intensity(), 1.0 / count);
        if (terms.diffuse() && !isNone("diffuse", "Kd", material.diffuse)) {
            say("diffuse = sum of ").say("Kd", KD).say(TIMES).say("LC/" + count, each).say(TIMES).say("(N·L)", FACING)
                .say(" over the points = ").sayFactor(material.diffuse, KD).say(TIMES).sayFactor(share, each).say(TIMES + "… = ").sayColour("", area.diffuse()).end();
        }
        if (terms.specular() && !isNone("specular", "Ks", material.specular)) {
            say("specular = sum of ").say("Ks", KS).say(TIMES).say("LC/" + count, each).say(TIMES).say("(N·H)", HIGHLIGHT)
                .say("^shininess", SHININESS).say(" over the points = ").sayFactor(material.specular, KS).say(TIMES).sayFactor(share, each)
                .say(TIMES + "…^" + number(material.shininess) + " = ").sayColour("", area.specular()).end();
        }
        if (area.lamps() == null) {
            say("its points are not told any more: the pixel has too many of them").end();
        }
        for (int i = 0; area.lamps() != null && i < area.lamps().size(); i++) {
            say("point " + (i + 1));
            tell(area.lamps().get(i), material);
        }
        level--;
    }

    private static String some(int number, String what) {
        return number == 0 ? "" : ", " + number + ' ' + what;
    }

    /** Tells a light, or a point of an area light, whose line is begun. */
    private void tell(Lamp one, Material material) {
        lamp = one;
        Verdict verdict = one.verdict();
        boolean lit = verdict.isLit();
        switch (verdict) {
            case TURNED_AWAY -> say(" is behind the surface");
            case NO_SHADOWS -> say(" shines, for this stage has no shadows: ");
            case REACHES -> say(" reaches the point: ");
            case DIMMED -> say(" reaches the point through ").sayObjects(between(one)).say(": ");
            case BLOCKED -> say(" is hidden by ").sayObjects(between(one));
            default -> throw new IllegalStateException(verdict.toString());
        }
        (lit ? sayColour("", both(one)) : this).end();
        level++;
        Colour arriving = verdict == Verdict.DIMMED ? one.arriving() : one.intensity();
        String meaning = verdict == Verdict.DIMMED ? ARRIVING : LC;
        if (verdict == Verdict.DIMMED) {
            say("arriving = ").say("LC", LC)
                .say((TIMES + "Kt").repeat(one.between().size()), "Kt, the share of light that an object lets through").say(" = ").sayFactor(one.intensity(), LC);
            one.between().forEach(b -> say(TIMES).sayFactor(b.transmission(), "Kt of object " + b.object().number()));
            say(" = ").sayColour("", arriving).end();
        }
        if (lit && terms.diffuse() && !isNone("diffuse", "Kd", material.diffuse)) {
            say("diffuse = ").say("Kd", KD).say(TIMES).say(verdict == Verdict.DIMMED ? "arriving" : "LC", meaning).say(TIMES)
                .say("(N·L)", FACING).say(" = ").sayFactor(material.diffuse, KD).say(TIMES).sayFactor(arriving, meaning).say(TIMES)
                .sayCosine(one.facing(), FACING).say(" = ").sayColour("", one.diffuse()).end();
        }
        if (lit && terms.specular() && !isNone("specular", "Ks", material.specular)) {
            say("specular = ").say("Ks", KS).say(TIMES).say(verdict == Verdict.DIMMED ? "arriving" : "LC", meaning).say(TIMES)
                .say("(N·H)", HIGHLIGHT).say("^shininess", SHININESS).say(" = ").sayFactor(material.specular, KS).say(TIMES)
                .sayFactor(arriving, meaning).say(TIMES).sayCosine(Math.min(1, Math.max(0, one.cosine())), HIGHLIGHT)
                .sayNumber('^' + number(material.shininess), SHININESS, material.shininess).say(" = ")
                .sayColour("", one.specular()).end();
        }
        say("L = ").sayVector(one.towards(), "L, the way to the light, of length 1").say(", N·L = ").sayCosine(one.facing(), FACING);
        if (!Double.isInfinite(one.distance())) {
            sayNumber(", distance " + number(one.distance()), "the distance of the light", one.distance());
        }
        end();
        if (lit && terms.specular() && !material.specular.isBlack()) {
            say("H = ").sayVector(one.halfway(), "H, halfway between L and the way back along the ray").say(", N·H = ")
                .sayCosine(one.cosine(), "N·H, the cosine of the angle between N and H").end();
        }
        level--;
        lamp = null;
    }

    private void tellNext(RayTree story) {
        Hit hit = story.hit();
        Material material = hit.material();
        boolean reflects = !material.mirrored().isBlack() || !material.transmission.isBlack();
        if (terms.reflections() && reflects && hit.mirror() == null && hit.refracted() == null) {
            say("no mirror or refracted ray: " + (story.depth() == 0 ? "the ray's depth is 0" : "the shininess is below 1")).end();
        }
        if (hit.mirror() != null) {
            String own = material.mirror == null ? "Ks" : "mirror";
            tell(hit.mirror().tree(), "Mirror ray: ", hit.mirror(), isTotal(hit) ? '(' + own + " + Kt)" : own);
        }
        if (hit.refracted() != null) {
            tell(hit.refracted().tree(), "Refracted ray: ", hit.refracted(), "Kt");
        }
    }
}
