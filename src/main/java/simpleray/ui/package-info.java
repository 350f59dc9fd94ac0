/** The window as a whole: its frame with menus and a status bar. The packages below hold its parts, which know it as an interface. */
package simpleray.ui;
