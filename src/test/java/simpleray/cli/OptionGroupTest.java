package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import simpleray.render.Accel;

/** What is declared of an option is what picocli knows of it, and picocli gives it its value. */
class OptionGroupTest {
    @Command
    private static final class Example {
        @Mixin
        private final OptionGroup group = new OptionGroup();
        private final CommandOption<String> text = group.add(CommandOption.text("TEXT", "A text.", "-t", "--text").required());
        private final CommandOption<Integer> number = group.add(CommandOption.integer("N", "A number.", "--number"));
        private final CommandOption<Boolean> flag = group.add(CommandOption.flag("A flag.", "--flag"));
        private final CommandOption<Accel> choice = group.add(CommandOption.choice(Accel.values(), Accel.AUTO, "HOW", "One.", "--choice"));
    }

    private final Example example = new Example();
    private final CommandLine line = new CommandLine(example);

    private OptionSpec option(String name) {
        return line.getCommandSpec().findOption(name);
    }

    @Test
    void aDeclarationIsPicoclisModel() {
        assertThat(line.getCommandSpec().options()).hasSize(4);
        assertThat(option("--text").names()).containsExactly("-t", "--text");
        assertThat(option("--text").paramLabel()).isEqualTo("TEXT");
        assertThat(option("--text").description()).containsExactly("A text.");
        assertThat(option("--text").required()).isTrue();
        assertThat(option("--text").completionCandidates()).isNull();
        assertThat(option("--number").required()).isFalse();
        assertThat(option("--number").defaultValue()).isNull();
        assertThat(option("--flag").arity().max()).isZero();
        assertThat(option("--choice").defaultValue()).isEqualTo("auto");
        assertThat(option("--choice").completionCandidates()).containsExactly("auto", "none");
    }

    @Test
    void whatIsNotGivenHasItsInitialValue() {
        line.parseArgs("-t", "");

        assertThat(example.text.value()).isEmpty();
        assertThat(example.number.value()).isNull();
        assertThat(example.flag.value()).isFalse();
        assertThat(example.choice.value()).isEqualTo(Accel.AUTO);
    }

    @Test
    void whatIsGivenIsTaken() {
        line.parseArgs("--flag", "--text=a b", "--number", "-7", "--choice", "NONE");

        assertThat(example.text.value()).isEqualTo("a b");
        assertThat(example.number.value()).isEqualTo(-7);
        assertThat(example.flag.value()).isTrue();
        assertThat(example.choice.value()).isEqualTo(Accel.NONE);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"--number 1.5 | Invalid value for option '--number': '1.5' is not an int",
        "--choice all | Invalid value for option '--choice': expected one of [auto, none], found 'all'",
        "--flag | Missing required option: '--text=TEXT'"})
    void picocliSaysWhatIsWrong(String args, String message) {
        assertThatThrownBy(() -> line.parseArgs(args.split(" "))).isInstanceOf(ParameterException.class).hasMessage(message);
    }
}
