package simpleray.image;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import simpleray.io.FileInUseException;

/** A process that begins a checkpoint and removes it, over and over, as others do at the same time. */
public final class CheckpointOwner {
    private static final int ROUNDS = 1500;

    private CheckpointOwner() {
    }

    /**
     * Prints how often it was the owner of the checkpoint; an exception ends it if it was not the only one.
     *
     * @param args the checkpoint, and a file that is there only while somebody is the owner
     * @throws IOException if there is another owner, or the checkpoint was not there as long as it was owned
     */
    public static void main(String[] args) throws IOException {
        Path path = Path.of(args[0]);
        Path owned = Path.of(args[1]);
        int owner = 0;
        for (int i = 0; i < ROUNDS || owner == 0; i++) {
            try {
                Checkpoint checkpoint = Checkpoint.create(path, Map.of("version", "1"), 6, 1);
                Files.createFile(owned);
                checkpoint.put(0, new byte[6], 0);
                if (!Map.of("version", "1").equals(Checkpoint.identity(path))) {
                    throw new IOException("the rows are in a file that nobody finds");
                }
                Files.delete(owned);
                checkpoint.remove();
                owner++;
            } catch (FileInUseException e) {
                Thread.yield();
            }
        }
        System.out.println(owner);
    }
}
