package simpleray.scene;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import simpleray.cli.Main;
import simpleray.math.Ray;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * The program with one more kind of object, 99, which throws when a ray asks for a hit; to be run in a virtual machine of its
 * own. With the property {@code memory} it throws what Java does when there is none left.
 */
public final class FaultyKind extends StandIn {
    /** Runs the program. */
    public static void main(String[] args) {
        ObjectKind.TABLE.add(new KindTable.Kind<>(99, "faulty", FaultyKind.class) {
            @Override
            Object make() {
                return new FaultyKind();
            }
        });
        System.exit(Main.run(args, System.in, new FileOutputStream(FileDescriptor.out), System.err));
    }

    @Override
    public double intersect(Ray ray) {
        if (Boolean.getBoolean("memory")) {
            throw new OutOfMemoryError("as if there were none left");
        }
        throw new IllegalStateException("a fault of this object");
    }

    @Override
    public void read(SceneReader is) {
        surfaceMaterial = new Material();
    }

    @Override
    public void write(SceneWriter os) throws IOException {
        os.writeInt(99);
    }
}
