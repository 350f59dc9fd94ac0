package simpleray.cli;

import java.util.List;

/** Writes a job for Slurm: an array of tasks, and what is to be done behind them. */
final class SlurmJob {
    /** So many tasks run at once at most, unless the user says otherwise: a disk that all nodes share has its limits. */
    private static final int AT_ONCE = 100;
    /** The time to join the bands of a picture or to look for it, in pictures as the estimate knows them. */
    private static final double MERGE = 0.05;

    private SlurmJob() {
    }

    /** {@return the script of the array} */
    static String render(JobPlan plan) {
        long last = plan.tasks() - 1;
        return script(plan, plan.name(), List.of("--array=0-" + last + "%" + Math.min(AT_ONCE, plan.tasks()), "--requeue",
                "--time=" + plan.estimate().minutes((double) Math.min(plan.chunk(), plan.pictures()) / plan.bands()),
                "--output=log/%x-%A_%a.txt"), "task \"$SLURM_ARRAY_TASK_ID\"");
    }

    /** {@return the script of the job behind it} */
    static String merge(JobPlan plan) {
        return script(plan, plan.name() + "-merge", List.of("--requeue", "--time=" + plan.estimate().minutes(1 + plan.pictures() * MERGE),
            "--output=log/%x-%j.txt"), "finish");
    }

    private static String script(JobPlan plan, String name, List<String> options, String words) {
        StringBuilder script = new StringBuilder("#!/bin/sh\n#SBATCH --job-name=" + name + "\n");
        options.forEach(option -> script.append("#SBATCH ").append(option).append('\n'));
        return script + "#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=1\n#SBATCH --mem=" + plan.estimate().memory() + "M\n"
            + "#SBATCH --open-mode=append\n"
            + "[ -f job.sh ] || { echo 'submit this from its own folder: there is no job.sh here' >&2; exit 66; }\n"
            + "exec sh job.sh " + words + '\n';
    }

    /** {@return the page that says how to run it} */
    static String readme(JobPlan plan, String version) {
        return JobScript.readme(plan, version, "Slurm", List.of(
            "    job=$(sbatch --parsable render.sbatch) && sbatch --dependency=afterany:${job%%;*} merge.sbatch",
            "Give this line in this folder, which all nodes must see under the same name. The last lines of log/" + plan.name()
                + "-merge-*.txt name what",
            "is missing, if anything is: then give the same line again, which renders only that. A task that fails tries again by itself.",
            "A task asks for " + plan.estimate().memory() + " MiB and " + plan.estimate().minutes(
                (double) Math.min(plan.chunk(), plan.pictures()) / plan.bands())
                + " minutes; sbatch's own options win: --mem=2G --time=60 --cpus-per-task=4 --array=0-" + (plan.tasks() - 1) + "%8"));
    }
}
