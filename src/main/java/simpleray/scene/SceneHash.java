package simpleray.scene;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import simpleray.io.Sha256;
import simpleray.text.SceneWriter;

/**
 * The SHA-256 of a scene in memory: its objects with all triangles and materials of their meshes, its lights and its ambient light. So it is right
 * even if the scene's files have changed; comments and settings do not count.
 */
public final class SceneHash {
    private static final int BUFFER = 1 << 13;

    private SceneHash() {
    }

    /**
     * Computes the hash.
     *
     * @param scene the scene, which must not change meanwhile
     * @return 64 hexadecimal digits
     */
    public static String of(Scene scene) {
        try {
            MessageDigest digest = Sha256.begin();
            SceneWriter writer = new SceneWriter(new DigestOutputStream(OutputStream.nullOutputStream(), digest));
            scene.with(new SceneSettings()).write(writer);
            writer.flush();
            Set<Triangles> done = Collections.newSetFromMap(new IdentityHashMap<>());
            for (int i = 0; i < scene.getNumberObjects(); i++) {
                if (scene.getObject(i) instanceof Mesh mesh && done.add(mesh.mesh().triangles)) {
                    add(digest, mesh.mesh().triangles);
                }
            }
            for (int i = 0; i < scene.getNumberObjects(); i++) {
                if (scene.getObject(i) instanceof Mesh mesh && mesh.materials() != null) {
                    add(digest, mesh.mesh().triangles.materials().all());
                    add(writer, mesh.materials());
                }
            }
            writer.flush();
            return Sha256.hex(digest.digest());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void add(MessageDigest digest, Triangles triangles) {
        add(digest, triangles.vertices());
        add(digest, triangles.corners());
        add(digest, triangles.normals());
        add(digest, triangles.cornerNormals());
    }

    private static void add(SceneWriter writer, MeshMaterials materials) throws IOException {
        for (int i = 0; i < materials.count(); i++) {
            if (materials.get(i) != null) {
                writer.writeInt(i);
                materials.get(i).write(writer);
                writer.writeNewline();
            }
        }
    }

    private static void add(MessageDigest digest, double[] numbers) {
        ByteBuffer bytes = begin(numbers.length);
        for (double number : numbers) {
            room(digest, bytes).putDouble(number);
        }
        digest.update(bytes.flip());
    }

    private static void add(MessageDigest digest, int[] numbers) {
        ByteBuffer bytes = begin(numbers == null ? -1 : numbers.length);
        for (int i = 0; numbers != null && i < numbers.length; i++) {
            room(digest, bytes).putInt(numbers[i]);
        }
        digest.update(bytes.flip());
    }

    private static ByteBuffer begin(int count) {
        return ByteBuffer.allocate(BUFFER).putInt(count);
    }

    private static ByteBuffer room(MessageDigest digest, ByteBuffer bytes) {
        if (bytes.remaining() < Double.BYTES) {
            digest.update(bytes.flip());
            bytes.clear();
        }
        return bytes;
    }
}
