package simpleray.cli;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.channels.SocketChannel;

/** A program that does what SimpleRay does not: ends with 0 if it can, with 1 if it cannot. */
public final class NetworkProbe {
    private NetworkProbe() {
    }

    /**
     * Uses the network, or starts a process.
     *
     * @param args how; and the port of somebody on this machine who listens
     * @throws IOException if that is refused
     */
    public static void main(String[] args) throws IOException {
        InetSocketAddress there = new InetSocketAddress(InetAddress.getByAddress(new byte[] {127, 0, 0, 1}), Integer.parseInt(args[1]));
        switch (args[0]) {
            case "socket" -> new Socket(there.getAddress(), there.getPort()).close();
            case "channel" -> SocketChannel.open(there).close();
            case "listen" -> new ServerSocket(0).close();
            case "datagram" -> new DatagramSocket().close();
            case "name" -> InetAddress.getByName("localhost");
            case "process" -> new ProcessBuilder("true").start().destroy();
            default -> throw new IllegalArgumentException(args[0]);
        }
    }
}
