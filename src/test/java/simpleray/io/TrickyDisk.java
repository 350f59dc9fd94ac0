package simpleray.io;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.ReadableByteChannel;
import java.nio.channels.SeekableByteChannel;
import java.nio.channels.WritableByteChannel;
import java.nio.file.AccessMode;
import java.nio.file.CopyOption;
import java.nio.file.DirectoryStream;
import java.nio.file.FileStore;
import java.nio.file.FileSystem;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.nio.file.WatchService;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.FileAttributeView;
import java.nio.file.attribute.UserPrincipalLookupService;
import java.nio.file.spi.FileSystemProvider;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** A disk like another, but for what a test has happen on it at chosen moments: faults, and what other processes do meanwhile. */
class TrickyDisk extends FileSystemProvider {
    /** Something that happens, told of the file on the other disk. */
    @FunctionalInterface
    interface Event {
        /** Happens. */
        void at(Path file) throws IOException;
    }

    /** A fault of the disk. */
    @FunctionalInterface
    interface Fault {
        /** Refuses an operation (channel, bytes, lock, write, truncate, move, delete or permissions) by an exception. */
        void at(String operation, Path file) throws IOException;
    }

    /** Asked before each operation. */
    Fault fault = (operation, file) -> { };
    /** Whether files can be locked; else somebody seems to have them. */
    boolean lockable = true;
    /** The views of attributes that the disk says it has. */
    Set<String> views = Set.of("basic");
    /** What happens next when a channel has been opened to lock a file; one event each time. */
    final Deque<Event> locking = new ArrayDeque<>();
    /** What happens before a file is opened to be written. */
    Event writing = file -> { };
    /** What happens when it is asked whether a file may be written or read. */
    Event asking = file -> { };
    /** Whether everything is a device. */
    boolean devices;
    /** The channels opened to lock a file. */
    final List<FileChannel> channels = new ArrayList<>();

    private final FileSystem system = new System();

    /** {@return the same file on this disk} */
    Path path(Path real) {
        Class<?>[] types = {Path.class, Real.class};
        return (Path) Proxy.newProxyInstance(TrickyDisk.class.getClassLoader(), types, (self, method, args) -> {
            if (method.getName().equals("real")) {
                return real;
            }
            if (method.getName().equals("getFileSystem")) {
                return system;
            }
            try {
                java.lang.Object[] others = args == null ? null : Arrays.stream(args).map(TrickyDisk::plain).toArray();
                java.lang.Object result = method.invoke(real, others);
                return result instanceof Path path ? path(path) : result;
            } catch (InvocationTargetException e) {
                throw e.getCause();
            }
        });
    }

    /** What knows the other disk's path. */
    private interface Real {
        /** {@return the path there} */
        Path real();
    }

    private static java.lang.Object plain(java.lang.Object path) {
        return path instanceof Real here ? here.real() : path;
    }

    private static Path real(Path path) {
        return (Path) plain(path);
    }

    private static FileSystemProvider provider(Path path) {
        return real(path).getFileSystem().provider();
    }

    @Override
    public FileChannel newFileChannel(Path path, Set<? extends OpenOption> options, FileAttribute<?>... attributes) throws IOException {
        fault.at("channel", real(path));
        FileChannel channel = new Channel(provider(path).newFileChannel(real(path), options, attributes), real(path));
        channels.add(channel);
        if (!locking.isEmpty()) {
            locking.remove().at(real(path));
        }
        return channel;
    }

    @Override
    public SeekableByteChannel newByteChannel(Path path, Set<? extends OpenOption> options, FileAttribute<?>... attributes)
            throws IOException {
        writing.at(real(path));
        fault.at("bytes", real(path));
        return provider(path).newByteChannel(real(path), options, attributes);
    }

    @Override
    public void checkAccess(Path path, AccessMode... modes) throws IOException {
        if (modes.length > 0) {
            asking.at(real(path));
        }
        provider(path).checkAccess(real(path), modes);
    }

    @Override
    public <A extends BasicFileAttributes> A readAttributes(Path path, Class<A> type, LinkOption... options) throws IOException {
        A there = provider(path).readAttributes(real(path), type, options);
        return type.cast(Proxy.newProxyInstance(TrickyDisk.class.getClassLoader(), new Class<?>[] {type}, (self, method, args) ->
            devices && method.getName().equals("isRegularFile") ? false : method.invoke(there, args)));
    }

    @Override
    public Path readSymbolicLink(Path link) throws IOException {
        return path(Files.readSymbolicLink(real(link)));
    }

    @Override
    public void delete(Path path) throws IOException {
        fault.at("delete", real(path));
        Files.delete(real(path));
    }

    @Override
    public void move(Path source, Path target, CopyOption... options) throws IOException {
        fault.at("move", real(target));
        Files.move(real(source), real(target), options);
    }

    @Override
    public boolean isSameFile(Path path, Path other) throws IOException {
        return Files.isSameFile(real(path), real(other));
    }

    @Override
    public <V extends FileAttributeView> V getFileAttributeView(Path path, Class<V> type, LinkOption... options) {
        V view = Files.getFileAttributeView(real(path), type, options);
        return type.cast(Proxy.newProxyInstance(TrickyDisk.class.getClassLoader(), new Class<?>[] {type}, (self, method, args) -> {
            if (method.getName().equals("setPermissions")) {
                fault.at("permissions", real(path));
            }
            return method.invoke(view, args);
        }));
    }

    @Override
    public String getScheme() {
        return "tricky";
    }

    @Override
    public FileSystem newFileSystem(URI uri, Map<String, ?> env) {
        throw new UnsupportedOperationException();
    }

    @Override
    public FileSystem getFileSystem(URI uri) {
        throw new UnsupportedOperationException();
    }

    @Override
    public Path getPath(URI uri) {
        throw new UnsupportedOperationException();
    }

    @Override
    public DirectoryStream<Path> newDirectoryStream(Path folder, DirectoryStream.Filter<? super Path> filter) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void createDirectory(Path folder, FileAttribute<?>... attributes) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void copy(Path source, Path target, CopyOption... options) {
        throw new UnsupportedOperationException();
    }

    @Override
    public boolean isHidden(Path path) {
        throw new UnsupportedOperationException();
    }

    @Override
    public FileStore getFileStore(Path path) {
        throw new UnsupportedOperationException();
    }

    @Override
    public Map<String, java.lang.Object> readAttributes(Path path, String attributes, LinkOption... options) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void setAttribute(Path path, String attribute, java.lang.Object value, LinkOption... options) {
        throw new UnsupportedOperationException();
    }

    /** A channel of this disk. */
    private final class Channel extends FileChannel {
        private final FileChannel channel;
        private final Path file;

        Channel(FileChannel channel, Path file) {
            this.channel = channel;
            this.file = file;
        }

        @Override
        public int read(ByteBuffer bytes) throws IOException {
            return channel.read(bytes);
        }

        @Override
        public long read(ByteBuffer[] bytes, int first, int count) throws IOException {
            return channel.read(bytes, first, count);
        }

        @Override
        public int read(ByteBuffer bytes, long place) throws IOException {
            return channel.read(bytes, place);
        }

        @Override
        public int write(ByteBuffer bytes) throws IOException {
            fault.at("write", file);
            return channel.write(bytes);
        }

        @Override
        public long write(ByteBuffer[] bytes, int first, int count) throws IOException {
            fault.at("write", file);
            return channel.write(bytes, first, count);
        }

        @Override
        public int write(ByteBuffer bytes, long place) throws IOException {
            fault.at("write", file);
            return channel.write(bytes, place);
        }

        @Override
        public long position() throws IOException {
            return channel.position();
        }

        @Override
        public FileChannel position(long place) throws IOException {
            channel.position(place);
            return this;
        }

        @Override
        public long size() throws IOException {
            return channel.size();
        }

        @Override
        public FileChannel truncate(long size) throws IOException {
            fault.at("truncate", file);
            channel.truncate(size);
            return this;
        }

        @Override
        public void force(boolean all) throws IOException {
            channel.force(all);
        }

        @Override
        public long transferTo(long place, long count, WritableByteChannel target) throws IOException {
            return channel.transferTo(place, count, target);
        }

        @Override
        public long transferFrom(ReadableByteChannel source, long place, long count) throws IOException {
            fault.at("write", file);
            return channel.transferFrom(source, place, count);
        }

        @Override
        public MappedByteBuffer map(MapMode mode, long place, long size) throws IOException {
            return channel.map(mode, place, size);
        }

        @Override
        public FileLock lock(long place, long size, boolean shared) throws IOException {
            fault.at("lock", file);
            return channel.lock(place, size, shared);
        }

        @Override
        public FileLock tryLock(long place, long size, boolean shared) throws IOException {
            fault.at("lock", file);
            return lockable ? channel.tryLock(place, size, shared) : null;
        }

        @Override
        protected void implCloseChannel() throws IOException {
            channel.close();
        }
    }

    /** Hands out this disk's provider, and knows little else. */
    private final class System extends FileSystem {
        @Override
        public FileSystemProvider provider() {
            return TrickyDisk.this;
        }

        @Override
        public Set<String> supportedFileAttributeViews() {
            return views;
        }

        @Override
        public boolean isOpen() {
            return true;
        }

        @Override
        public boolean isReadOnly() {
            return false;
        }

        @Override
        public String getSeparator() {
            return "/";
        }

        @Override
        public void close() {
            throw new UnsupportedOperationException();
        }

        @Override
        public Iterable<Path> getRootDirectories() {
            throw new UnsupportedOperationException();
        }

        @Override
        public Iterable<FileStore> getFileStores() {
            throw new UnsupportedOperationException();
        }

        @Override
        public Path getPath(String first, String... more) {
            throw new UnsupportedOperationException();
        }

        @Override
        public PathMatcher getPathMatcher(String pattern) {
            throw new UnsupportedOperationException();
        }

        @Override
        public UserPrincipalLookupService getUserPrincipalLookupService() {
            throw new UnsupportedOperationException();
        }

        @Override
        public WatchService newWatchService() {
            throw new UnsupportedOperationException();
        }
    }
}
