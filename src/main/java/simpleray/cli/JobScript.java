package simpleray.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import simpleray.text.Diagnostic;
import simpleray.ui.picture.ShellWords;

/** Writes what jobs of all engines have: the script that does their pieces, and the page that says how to run them. */
final class JobScript {
    /** The folder of the scene and of the files that it names. */
    static final String SCENE_FOLDER = "scene/";
    private static final String RESOURCE = "/simpleray/job.sh";
    private static final String PLACE = "#@job@\n";

    private JobScript() {
    }

    /** {@return the script} */
    static String of(JobPlan plan) {
        String words = plan.options().isEmpty() ? "" : ShellWords.posix(plan.options()) + ' ';
        String job = "scene=" + ShellWords.quoted(SCENE_FOLDER + plan.scene()) + '\n'
            + "still=" + (plan.frames() == null ? "yes" : "") + " frames=" + (plan.frames() == null ? "0-0" : plan.frames()) + '\n'
            + "bands=" + plan.bands() + " chunk=" + plan.chunk() + " digits=" + plan.digits() + " java=" + JobEstimate.JAVA + '\n'
            + "film=" + (plan.film() == null ? "" : ShellWords.quoted(plan.film())) + '\n'
            + "# options COMMAND SCENE ARG...: the program with the options that say which picture is made of the scene\n"
            + "options() {\n    what=$1\n    shift 2\n    program \"$what\" \"$scene\" " + words + "\"$@\"\n}\n";
        return resource().replace(PLACE, job);
    }

    private static String resource() {
        try (InputStream in = JobScript.class.getResourceAsStream(RESOURCE)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("\r\n", "\n");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** {@return the page that says how to run a job: ten lines} */
    static String readme(JobPlan plan, String version, String engine, List<String> how) {
        String out = plan.frames() == null ? "picture.png" : "frames/" + (plan.film() == null ? "" : ", and the film is " + plan.film());
        return Diagnostic.printable(plan.scene()) + ": " + plan.what() + ", a job for " + engine + ", written by SimpleRay " + version + "\n\n"
            + String.join("\n", how) + "\n\n"
            + "Pictures are in " + out + ". Each machine needs the same version of SimpleRay: the program simpleray on the PATH,\n"
            + "or its path in the variable SIMPLERAY. Without an engine: sh job.sh task K, for K from 0 to " + (plan.tasks() - 1)
            + ", then sh job.sh finish.\n"
            + "What is there and whole is never rendered again; docs/many-machines.md has more.\n";
    }
}
