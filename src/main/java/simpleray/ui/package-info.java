/** The window, and the only Swing. Threads hand finished rows over in a queue; what shows them is touched by the event thread alone. */
package simpleray.ui;
