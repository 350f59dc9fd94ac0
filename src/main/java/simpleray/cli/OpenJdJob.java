package simpleray.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Writes a job as a template of Open Job Description, version 2023-09, in JSON. */
final class OpenJdJob {
    private static final String FRAME = "Frame";
    private static final String BAND = "Band";

    private OpenJdJob() {
    }

    /** {@return the template} */
    static String template(JobPlan plan) {
        List<String> steps = new ArrayList<>();
        boolean film = plan.frames() != null;
        List<String> render = Stream.of(film ? FRAME : null, plan.bands() > 1 ? BAND : null).filter(name -> name != null).toList();
        List<String> words = new ArrayList<>(List.of("render", film ? value(FRAME) : "0"));
        if (plan.bands() > 1) {
            words.add(value(BAND));
        }
        steps.add(step("Render", null, plan, render, words));
        if (plan.bands() > 1) {
            steps.add(step("Merge", "Render", plan, film ? List.of(FRAME) : List.of(), film ? List.of("merge", value(FRAME)) : List.of("merge")));
        }
        if (plan.film() != null) {
            steps.add(step("Film", plan.bands() > 1 ? "Merge" : "Render", plan, List.of(), List.of("film")));
        }
        return "{\n  \"specificationVersion\": \"jobtemplate-2023-09\",\n"
            + (film && plan.chunk() > 1 ? "  \"extensions\": [\"TASK_CHUNKING\"],\n" : "")
            + "  \"name\": " + Json.string(plan.name()) + ",\n"
            + "  \"parameterDefinitions\": [\n    {\"name\": \"JobFolder\", \"type\": \"PATH\", \"objectType\": \"DIRECTORY\", "
            + "\"dataFlow\": \"INOUT\", \"default\": \".\",\n     \"description\": \"The folder of this template\"}\n  ],\n"
            + "  \"steps\": [\n" + String.join(",\n", steps) + "\n  ]\n}\n";
    }

    private static String value(String parameter) {
        return "{{Task.Param." + parameter + "}}";
    }

    private static String step(String name, String before, JobPlan plan, List<String> parameters, List<String> words) {
        String dependencies = before == null ? "" : "      \"dependencies\": [{\"dependsOn\": " + Json.string(before) + "}],\n";
        String space = parameters.isEmpty() ? "" : "      \"parameterSpace\": {\"taskParameterDefinitions\": [\n"
            + parameters.stream().map(parameter -> "        " + parameter(parameter, plan)).collect(Collectors.joining(",\n")) + "\n      ]},\n";
        String args = Stream.concat(Stream.of("{{Param.JobFolder}}/job.sh", "openjd"), words.stream()).map(Json::string)
            .collect(Collectors.joining(", "));
        return "    {\n      \"name\": " + Json.string(name) + ",\n" + dependencies + space
            + "      \"hostRequirements\": {\"amounts\": [{\"name\": \"amount.worker.memory\", \"min\": " + plan.estimate().memory() + "}]},\n"
            + "      \"script\": {\"actions\": {\"onRun\": {\"command\": \"sh\", \"args\": [" + args + "]}}}\n    }";
    }

    private static String parameter(String name, JobPlan plan) {
        if (name.equals(BAND)) {
            return "{\"name\": \"Band\", \"type\": \"INT\", \"range\": \"1-" + plan.bands() + "\"}";
        }
        return "{\"name\": \"Frame\", \"type\": " + (plan.chunk() > 1 ? "\"CHUNK[INT]\"" : "\"INT\"") + ", \"range\": "
            + Json.string(plan.frames().toString())
            + (plan.chunk() > 1 ? ", \"chunks\": {\"defaultTaskCount\": " + plan.chunk() + ", \"rangeConstraint\": \"CONTIGUOUS\"}" : "") + '}';
    }

    /** {@return the page that says how to run it} */
    static String readme(JobPlan plan, String version) {
        return JobScript.readme(plan, version, "Open Job Description", List.of(
            "    openjd check template.json && openjd run template.json",
            "Give this line in this folder to run it here (pip install openjd-cli). Other engines take template.json as it is: a job bundle is this",
            "folder. Workers must see the folder, or be given it and give it back, as its parameter JobFolder says.",
            "If a task fails, run it again, or all of it: only what is missing is rendered."));
    }
}
