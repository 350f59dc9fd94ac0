/** Where the scene of a window comes from: a file, which is read, watched and written, or a text in memory. */
package simpleray.ui.file;
