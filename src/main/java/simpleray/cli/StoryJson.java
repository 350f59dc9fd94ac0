package simpleray.cli;

import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.render.PixelStory;
import simpleray.scene.Material;
import simpleray.scene.RayTree.Area;
import simpleray.scene.RayTree.Between;
import simpleray.scene.RayTree.Contribution;
import simpleray.scene.RayTree.Hit;
import simpleray.scene.RayTree.Lamp;
import simpleray.scene.RayTree.Next;
import simpleray.scene.RayTree.Thing;
import simpleray.scene.RayTree;
import simpleray.text.ShortestDecimal;

/** A pixel's story as one JSON object, its numbers to the last bit. What is infinite, or not known, is null. */
final class StoryJson {
    private final StringBuilder out = new StringBuilder();

    private StoryJson() {
    }

    static String of(PixelStory pixel) {
        StoryJson json = new StoryJson();
        json.tell(pixel);
        return json.out.append('\n').toString();
    }

    private void tell(PixelStory pixel) {
        out.append("{\"x\":").append(pixel.x()).append(",\"y\":").append(pixel.y());
        out.append(",\"width\":").append(pixel.width()).append(",\"height\":").append(pixel.height());
        out.append(",\"stage\":\"").append(pixel.stage()).append('"');
        colour("colour", pixel.colour());
        out.append(",\"levels\":[").append(Picture.level(pixel.colour().r)).append(',').append(Picture.level(pixel.colour().g))
            .append(',').append(Picture.level(pixel.colour().b)).append(']');
        pixel.alpha().ifPresent(alpha -> value("alpha", alpha));
        out.append(",\"mean\":").append(pixel.mean());
        list("samples", pixel.samples(), this::tell);
        out.append('}');
    }

    private void tell(PixelStory.Sample sample) {
        out.append("{\"at\":[");
        number(sample.px());
        out.append(',');
        number(sample.py());
        out.append("],\"clamped\":").append(sample.clamped());
        colour("colour", sample.colour());
        name("ray");
        tell(sample.tree());
        out.append('}');
    }

    private void tell(RayTree story) {
        Point from = story.ray().origin;
        out.append("{\"origin\":");
        triple(from.x, from.y, from.z);
        vector("direction", story.ray().direction);
        out.append(",\"depth\":").append(story.depth());
        out.append(",\"told\":").append(story.told());
        colour("colour", story.colour());
        name("hit");
        if (story.hit() == null) {
            out.append("null");
        } else {
            tell(story.hit());
        }
        out.append('}');
    }

    private void tell(Hit hit) {
        out.append('{');
        thing(hit.object());
        value("distance", hit.distance());
        name("point");
        triple(hit.point().x, hit.point().y, hit.point().z);
        vector("normal", hit.normal());
        out.append(",\"enters\":").append(hit.enters());
        name("material");
        tell(hit.material());
        colour("GA", hit.light());
        colour("ambient", hit.ambient());
        list("lights", hit.lamps(), this::tell);
        colour("diffuse", hit.diffuse());
        colour("specular", hit.specular());
        next("mirror", hit.mirror());
        next("refracted", hit.refracted());
        out.append('}');
    }

    private void tell(Material material) {
        out.append("{\"Ka\":");
        triple(material.ambient.r, material.ambient.g, material.ambient.b);
        colour("Kd", material.diffuse);
        colour("Ks", material.specular);
        value("shininess", material.shininess);
        if (material.mirror != null) {
            colour("mirror", material.mirror);
        }
        colour("Kt", material.transmission);
        value("index", material.index);
        out.append('}');
    }

    private void tell(Contribution light) {
        if (light instanceof Area area) {
            tell(area);
        } else {
            tell((Lamp) light);
        }
    }

    private void tell(Area area) {
        out.append('{');
        thing(area.light());
        colour("LC", area.intensity());
        out.append(",\"points\":").append(area.points()).append(",\"whole\":").append(area.whole());
        out.append(",\"dimmed\":").append(area.dimmed()).append(",\"blocked\":").append(area.blocked());
        out.append(",\"turned away\":").append(area.turnedAway()).append(",\"shadows\":").append(area.shadows());
        orNull("between", area.between(), this::told);
        colour("diffuse", area.diffuse());
        colour("specular", area.specular());
        orNull("each", area.lamps(), this::tell);
        out.append('}');
    }

    private void told(Thing thing) {
        out.append('{');
        thing(thing);
        out.append('}');
    }

    private void tell(Lamp lamp) {
        out.append('{');
        thing(lamp.light());
        colour("LC", lamp.intensity());
        value("distance", lamp.distance());
        vector("L", lamp.towards());
        value("N.L", lamp.facing());
        vector("H", lamp.halfway());
        value("N.H", lamp.cosine());
        out.append(",\"verdict\":\"").append(lamp.verdict().name().toLowerCase(Locale.ROOT).replace('_', ' ')).append('"');
        list("between", lamp.between(), this::tell);
        colour("arriving", lamp.arriving());
        colour("diffuse", lamp.diffuse());
        colour("specular", lamp.specular());
        out.append('}');
    }

    private void tell(Between between) {
        out.append('{');
        thing(between.object());
        colour("Kt", between.transmission());
        out.append('}');
    }

    private void next(String name, Next next) {
        name(name);
        if (next == null) {
            out.append("null");
            return;
        }
        out.append("{\"share\":");
        triple(next.share().r, next.share().g, next.share().b);
        colour("colour", next.colour());
        name("ray");
        tell(next.tree());
        out.append('}');
    }

    private void thing(Thing thing) {
        out.append("\"number\":").append(thing.number()).append(",\"kind\":\"").append(thing.kind()).append("\",\"line\":")
            .append(thing.line() > 0 ? Integer.toString(thing.line()) : "null");
        if (thing.mtl() != null) {
            out.append(",\"mtl\":{\"name\":").append(Json.string(thing.mtl().name())).append(",\"file\":").append(Json.string(thing.mtl().file()))
                .append(",\"line\":").append(thing.mtl().line()).append('}');
        }
    }

    private <T> void orNull(String name, List<T> all, Consumer<T> teller) {
        if (all == null) {
            name(name);
            out.append("null");
        } else {
            list(name, all, teller);
        }
    }

    private <T> void list(String name, List<T> all, Consumer<T> teller) {
        name(name);
        out.append('[');
        for (int i = 0; i < all.size(); i++) {
            out.append(i == 0 ? "" : ",");
            teller.accept(all.get(i));
        }
        out.append(']');
    }

    private void name(String name) {
        out.append(",\"").append(name).append("\":");
    }

    private void value(String name, double value) {
        name(name);
        number(value);
    }

    private void colour(String name, Colour c) {
        name(name);
        triple(c.r, c.g, c.b);
    }

    private void vector(String name, Vector v) {
        name(name);
        triple(v.x, v.y, v.z);
    }

    private void triple(double a, double b, double c) {
        out.append('[');
        number(a);
        out.append(',');
        number(b);
        out.append(',');
        number(c);
        out.append(']');
    }

    private void number(double d) {
        out.append(Double.isFinite(d) ? ShortestDecimal.of(d) : "null");
    }
}
