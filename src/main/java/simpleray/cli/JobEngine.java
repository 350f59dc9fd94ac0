package simpleray.cli;

import java.util.Locale;

/** What runs a job on many machines. */
enum JobEngine {
    /** Whatever runs templates of Open Job Description. */
    OPENJD {
        @Override
        void write(JobPlan plan, JobFolder folder) throws CommandException {
            folder.write("template.json", OpenJdJob.template(plan));
            folder.write(README, OpenJdJob.readme(plan, Main.version()));
        }
    },
    /** The cluster manager. */
    SLURM {
        @Override
        void write(JobPlan plan, JobFolder folder) throws CommandException {
            folder.makeFolder("log");
            folder.write("render.sbatch", SlurmJob.render(plan));
            folder.write("merge.sbatch", SlurmJob.merge(plan));
            folder.write(README, SlurmJob.readme(plan, Main.version()));
        }
    };

    private static final String README = "README.txt";

    /** Writes what only this engine needs; the last file is the one that says how to begin. */
    abstract void write(JobPlan plan, JobFolder folder) throws CommandException;

    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
