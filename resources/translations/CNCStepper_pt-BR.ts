<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_BR" sourcelanguage="en">
    <context>
        <name>App::Property</name>
        <message>
            <source>A TrueType or OpenType file, instead of the font</source>
            <translation>Um arquivo TrueType ou OpenType, em vez da fonte</translation>
        </message>
        <message>
            <source>A factor of the font's own</source>
            <translation>Um fator da entrelinha da própria fonte</translation>
        </message>
        <message>
            <source>A font of the system, or a single-line font for engraving</source>
            <translation>Uma fonte do sistema, ou uma fonte de linha única para gravar</translation>
        </message>
        <message>
            <source>A laser's S word for marks; 0: a twentieth of its power</source>
            <translation>A palavra S do laser para marcas; 0: um vigésimo da potência</translation>
        </message>
        <message>
            <source>A laser's power that rises behind the pierce</source>
            <translation>Potência do laser que sobe depois da perfuração</translation>
        </message>
        <message>
            <source>A lower feed at corners</source>
            <translation>Avanço menor nos cantos</translation>
        </message>
        <message>
            <source>A lower feed on arcs of a small radius</source>
            <translation>Avanço menor em arcos de raio pequeno</translation>
        </message>
        <message>
            <source>A share of the machine's greatest power; 0: that of the chart</source>
            <translation>Uma parte da potência máxima da máquina; 0: a da tabela</translation>
        </message>
        <message>
            <source>A shipped profile's name, or a profile's file</source>
            <translation>O nome de um perfil fornecido, ou o arquivo de um perfil</translation>
        </message>
        <message>
            <source>A sketch or wire that holds one circle; without it the numbers count</source>
            <translation>Um esboço ou fio que contenha um círculo; sem ele valem os números</translation>
        </message>
        <message>
            <source>A sketch or wire that holds one ellipse; without it the numbers count</source>
            <translation>Um esboço ou arame com uma elipse; sem ele valem os números</translation>
        </message>
        <message>
            <source>A sketch or wire that holds one rectangle; without it the numbers count</source>
            <translation>Um esboço ou fio que contenha um retângulo; sem ele valem os números</translation>
        </message>
        <message>
            <source>A sketch, wires or faces: closed lines, those inside are islands</source>
            <translation>Um esboço, fios ou faces: linhas fechadas, as de dentro são ilhas</translation>
        </message>
        <message>
            <source>A tool of this shape has none</source>
            <translation>Uma ferramenta desta forma não tem este valor</translation>
        </message>
        <message>
            <source>About the first corner, counter-clockwise</source>
            <translation>Em torno do primeiro canto, no sentido anti-horário</translation>
        </message>
        <message>
            <source>Above</source>
            <translation>Acima</translation>
        </message>
        <message>
            <source>Active</source>
            <translation>Ativa</translation>
        </message>
        <message>
            <source>Added between letters</source>
            <translation>Acrescentado entre as letras</translation>
        </message>
        <message>
            <source>Align</source>
            <translation>Alinhamento</translation>
        </message>
        <message>
            <source>Alignment</source>
            <translation>Alinhamento</translation>
        </message>
        <message>
            <source>All, the outline, or the holes in it</source>
            <translation>Todas, o contorno, ou os furos nele</translation>
        </message>
        <message>
            <source>All, the outlines of letters, or the holes in them</source>
            <translation>Todas, os contornos das letras, ou os furos nelas</translation>
        </message>
        <message>
            <source>Along</source>
            <translation>Ao longo de</translation>
        </message>
        <message>
            <source>Along a line or arc</source>
            <translation>Ao longo de uma linha ou arco</translation>
        </message>
        <message>
            <source>Amperes</source>
            <translation>Ampères</translation>
        </message>
        <message>
            <source>Angle</source>
            <translation>Ângulo</translation>
        </message>
        <message>
            <source>Angle in</source>
            <translation>Ângulo entrada</translation>
        </message>
        <message>
            <source>Angle out</source>
            <translation>Ângulo saída</translation>
        </message>
        <message>
            <source>Arc Centre</source>
            <translation>Centro do arco</translation>
        </message>
        <message>
            <source>Arc Radius</source>
            <translation>Raio do arco</translation>
        </message>
        <message>
            <source>Arc Start</source>
            <translation>Início do arco</translation>
        </message>
        <message>
            <source>Arc Sweep</source>
            <translation>Abertura do arco</translation>
        </message>
        <message>
            <source>Arcs By</source>
            <translation>Regra dos arcos</translation>
        </message>
        <message>
            <source>Arcs Feed Share</source>
            <translation>Parte do avanço nos arcos</translation>
        </message>
        <message>
            <source>Arcs Radius</source>
            <translation>Raio dos arcos</translation>
        </message>
        <message>
            <source>Arcs and lines this close to the drawn points, instead of the tolerance; 0: straight lines</source>
            <translation>Arcos e linhas a esta distância dos pontos desenhados, em vez da tolerância; 0: linhas retas</translation>
        </message>
        <message>
            <source>Arcs below</source>
            <translation>Arcos abaixo de</translation>
        </message>
        <message>
            <source>Arcs of a smaller radius are cut slowly; 0: none</source>
            <translation>Arcos de raio menor são cortados devagar; 0: nenhum</translation>
        </message>
        <message>
            <source>Arcs within a tolerance, or the published points</source>
            <translation>Arcos dentro de uma tolerância, ou os pontos publicados</translation>
        </message>
        <message>
            <source>As a multiple of the thickness; 0: none by thickness</source>
            <translation>Como múltiplo da espessura; 0: nenhum pela espessura</translation>
        </message>
        <message>
            <source>At smaller corners the wire neither pauses nor slows down</source>
            <translation>Onde o caminho vira menos, o fio nem para nem vai mais devagar</translation>
        </message>
        <message>
            <source>Below thickness times</source>
            <translation>Abaixo de × espessura</translation>
        </message>
        <message>
            <source>Below this grey, 1 to 255, it is dark; 0: found from the picture</source>
            <translation>Abaixo deste cinza, 1 a 255, é escuro; 0: achado na imagem</translation>
        </message>
        <message>
            <source>Between neighbouring helices at most; 0: 0.4 of the tool's diameter</source>
            <translation>Entre hélices vizinhas no máximo; 0: 0,4 do diâmetro da ferramenta</translation>
        </message>
        <message>
            <source>Between the two sides of a V-bit or engraver; 0: not given</source>
            <translation>Entre os dois lados de uma fresa em V ou de gravação; 0: não informado</translation>
        </message>
        <message>
            <source>Between the two sides of a drill's point; 0: not given</source>
            <translation>Entre os dois lados da ponta de uma broca; 0: não informado</translation>
        </message>
        <message>
            <source>Beyond</source>
            <translation>Além</translation>
        </message>
        <message>
            <source>Blade Offset</source>
            <translation>Recuo da lâmina</translation>
        </message>
        <message>
            <source>Blade offset</source>
            <translation>Recuo da lâmina</translation>
        </message>
        <message>
            <source>Blur</source>
            <translation>Desfoque</translation>
        </message>
        <message>
            <source>Bridges that hold the part until it is broken out</source>
            <translation>Pontes que seguram a peça até ela ser destacada</translation>
        </message>
        <message>
            <source>By Colour</source>
            <translation>Por cor</translation>
        </message>
        <message>
            <source>By colour</source>
            <translation>Por cor</translation>
        </message>
        <message>
            <source>Centre</source>
            <translation>Centro</translation>
        </message>
        <message>
            <source>Chains</source>
            <translation>Contornos</translation>
        </message>
        <message>
            <source>Changes of the job's own program since then</source>
            <translation>O que aconteceu desde então com o programa do próprio trabalho</translation>
        </message>
        <message>
            <source>Chart</source>
            <translation>Tabela</translation>
        </message>
        <message>
            <source>Chip Load Max</source>
            <translation>Avanço por dente máximo</translation>
        </message>
        <message>
            <source>Chip Load Min</source>
            <translation>Avanço por dente mínimo</translation>
        </message>
        <message>
            <source>Circle</source>
            <translation>Círculo</translation>
        </message>
        <message>
            <source>Clamp Containers</source>
            <translation>Recipientes dos grampos</translation>
        </message>
        <message>
            <source>Clamp Outlines</source>
            <translation>Contornos dos grampos</translation>
        </message>
        <message>
            <source>Clamps</source>
            <translation>Grampos</translation>
        </message>
        <message>
            <source>Clearance</source>
            <translation>Altura de segurança</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Fechar</translation>
        </message>
        <message>
            <source>Close gaps</source>
            <translation>Fechar vãos</translation>
        </message>
        <message>
            <source>Closed</source>
            <translation>Fechada</translation>
        </message>
        <message>
            <source>Closed lines around the area to face; without them the whole stock</source>
            <translation>Linhas fechadas em volta do que é faceado; sem elas, o bloco inteiro</translation>
        </message>
        <message>
            <source>Columns</source>
            <translation>Colunas</translation>
        </message>
        <message>
            <source>Consumable</source>
            <translation>Consumível</translation>
        </message>
        <message>
            <source>Containers</source>
            <translation>Recipientes</translation>
        </message>
        <message>
            <source>Containers of the clamps</source>
            <translation>Recipientes dos grampos</translation>
        </message>
        <message>
            <source>Contours</source>
            <translation>Contornos</translation>
        </message>
        <message>
            <source>Coolant</source>
            <translation>Refrigeração</translation>
        </message>
        <message>
            <source>Core Diameter</source>
            <translation>Diâmetro do núcleo</translation>
        </message>
        <message>
            <source>Core diameter</source>
            <translation>Diâmetro do núcleo</translation>
        </message>
        <message>
            <source>Corner A</source>
            <translation>Canto A</translation>
        </message>
        <message>
            <source>Corner Angle</source>
            <translation>Ângulo do canto</translation>
        </message>
        <message>
            <source>Corner B</source>
            <translation>Canto B</translation>
        </message>
        <message>
            <source>Corner Distance</source>
            <translation>Distância do canto</translation>
        </message>
        <message>
            <source>Corner Dwell</source>
            <translation>Pausa no canto</translation>
        </message>
        <message>
            <source>Corner Feed Share</source>
            <translation>Parte do avanço no canto</translation>
        </message>
        <message>
            <source>Corner Radius</source>
            <translation>Raio de canto</translation>
        </message>
        <message>
            <source>Corner angle</source>
            <translation>Ângulo do canto</translation>
        </message>
        <message>
            <source>Corner distance</source>
            <translation>Distância do canto</translation>
        </message>
        <message>
            <source>Corner dwell</source>
            <translation>Pausa no canto</translation>
        </message>
        <message>
            <source>Corner radius</source>
            <translation>Raio de canto</translation>
        </message>
        <message>
            <source>Corners</source>
            <translation>Cantos</translation>
        </message>
        <message>
            <source>Corners Angle</source>
            <translation>Ângulo dos cantos</translation>
        </message>
        <message>
            <source>Corners By</source>
            <translation>Regra dos cantos</translation>
        </message>
        <message>
            <source>Corners Distance</source>
            <translation>Distância dos cantos</translation>
        </message>
        <message>
            <source>Corners Feed Share</source>
            <translation>Parte do avanço nos cantos</translation>
        </message>
        <message>
            <source>Corners above</source>
            <translation>Cantos acima de</translation>
        </message>
        <message>
            <source>Corners that turn by more are cut slowly; 0: none</source>
            <translation>Cantos que viram mais são cortados devagar; 0: nenhum</translation>
        </message>
        <message>
            <source>Count</source>
            <translation>Quantidade</translation>
        </message>
        <message>
            <source>Current</source>
            <translation>Corrente</translation>
        </message>
        <message>
            <source>Curve Count</source>
            <translation>Número de curvas</translation>
        </message>
        <message>
            <source>Curves</source>
            <translation>Curvas</translation>
        </message>
        <message>
            <source>Cut</source>
            <translation>Corte</translation>
        </message>
        <message>
            <source>Cut Feed</source>
            <translation>Avanço de corte</translation>
        </message>
        <message>
            <source>Cut Height</source>
            <translation>Altura de corte</translation>
        </message>
        <message>
            <source>Cut Length</source>
            <translation>Comprimento do corte</translation>
        </message>
        <message>
            <source>Cut chart</source>
            <translation>Tabela de corte</translation>
        </message>
        <message>
            <source>Cut height</source>
            <translation>Altura de corte</translation>
        </message>
        <message>
            <source>Cut length</source>
            <translation>Comprimento do corte</translation>
        </message>
        <message>
            <source>Cutting</source>
            <translation>Corte</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Ciclo</translation>
        </message>
        <message>
            <source>Deleted Drawing</source>
            <translation>Desenho excluído</translation>
        </message>
        <message>
            <source>Deleted drawing</source>
            <translation>Desenho excluído</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>Profundidade</translation>
        </message>
        <message>
            <source>Depth Of</source>
            <translation>Profundidade de</translation>
        </message>
        <message>
            <source>Depth to</source>
            <translation>Profundidade até</translation>
        </message>
        <message>
            <source>Dialect</source>
            <translation>Dialeto</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>Diâmetro</translation>
        </message>
        <message>
            <source>Dimensions</source>
            <translation>Dimensões</translation>
        </message>
        <message>
            <source>Direction</source>
            <translation>Sentido</translation>
        </message>
        <message>
            <source>Dog-bones</source>
            <translation>Alívio de cantos</translation>
        </message>
        <message>
            <source>Dogbones</source>
            <translation>Alívio de cantos</translation>
        </message>
        <message>
            <source>Double</source>
            <translation>Duplicada</translation>
        </message>
        <message>
            <source>Doubles</source>
            <translation>Duplicadas</translation>
        </message>
        <message>
            <source>Drawing</source>
            <translation>Desenho</translation>
        </message>
        <message>
            <source>Drawing, solid or picture</source>
            <translation>Desenho, sólido ou imagem</translation>
        </message>
        <message>
            <source>Drawings</source>
            <translation>Desenhos</translation>
        </message>
        <message>
            <source>Dwell</source>
            <translation>Pausa</translation>
        </message>
        <message>
            <source>Dynamic Power</source>
            <translation>Potência dinâmica</translation>
        </message>
        <message>
            <source>Dynamic power</source>
            <translation>Potência dinâmica</translation>
        </message>
        <message>
            <source>Edge Margin</source>
            <translation>Margem da borda</translation>
        </message>
        <message>
            <source>Edge margin</source>
            <translation>Margem da borda</translation>
        </message>
        <message>
            <source>Ellipse</source>
            <translation>Elipse</translation>
        </message>
        <message>
            <source>End angle</source>
            <translation>Ângulo final</translation>
        </message>
        <message>
            <source>Ends that are nearer than this are moved together</source>
            <translation>Pontas mais próximas que isto são unidas</translation>
        </message>
        <message>
            <source>Engagement</source>
            <translation>Engajamento</translation>
        </message>
        <message>
            <source>Engagement Max</source>
            <translation>Ângulo de contato máximo</translation>
        </message>
        <message>
            <source>Enter From</source>
            <translation>Entra por</translation>
        </message>
        <message>
            <source>Enter from</source>
            <translation>Entra por</translation>
        </message>
        <message>
            <source>Entry</source>
            <translation>Entrada</translation>
        </message>
        <message>
            <source>Entry Angle</source>
            <translation>Ângulo de entrada</translation>
        </message>
        <message>
            <source>Entry Slit</source>
            <translation>Fenda de entrada</translation>
        </message>
        <message>
            <source>Entry angle</source>
            <translation>Ângulo de entrada</translation>
        </message>
        <message>
            <source>Entry slit</source>
            <translation>Fenda de entrada</translation>
        </message>
        <message>
            <source>Exit of the wire: back along its entry, or the shortest way to an edge</source>
            <translation>Como o fio sai no fim: de volta pelo mesmo caminho, ou pelo caminho mais curto até uma borda</translation>
        </message>
        <message>
            <source>Extra depth, so that the tool comes out below</source>
            <translation>Quanto a ferramenta desce a mais para sair por baixo</translation>
        </message>
        <message>
            <source>Faults</source>
            <translation>Falhas</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>Avanço</translation>
        </message>
        <message>
            <source>Feed Used</source>
            <translation>Avanço usado</translation>
        </message>
        <message>
            <source>Feed at corners</source>
            <translation>Avanço nos cantos</translation>
        </message>
        <message>
            <source>Feed of arcs</source>
            <translation>Avanço dos arcos</translation>
        </message>
        <message>
            <source>Feed of holes</source>
            <translation>Avanço dos furos</translation>
        </message>
        <message>
            <source>Figures</source>
            <translation>Valores</translation>
        </message>
        <message>
            <source>File</source>
            <translation>Arquivo</translation>
        </message>
        <message>
            <source>File State</source>
            <translation>Estado do arquivo</translation>
        </message>
        <message>
            <source>Finish</source>
            <translation>Acabamento</translation>
        </message>
        <message>
            <source>Finish Feed</source>
            <translation>Avanço de acabamento</translation>
        </message>
        <message>
            <source>Finish Stepdown</source>
            <translation>Última profundidade de corte</translation>
        </message>
        <message>
            <source>Finish Stepover</source>
            <translation>Última penetração de trabalho</translation>
        </message>
        <message>
            <source>First corner</source>
            <translation>Primeiro canto</translation>
        </message>
        <message>
            <source>First hole</source>
            <translation>Primeiro furo</translation>
        </message>
        <message>
            <source>Flute Length</source>
            <translation>Comprimento de corte</translation>
        </message>
        <message>
            <source>Flute length</source>
            <translation>Comprimento de corte</translation>
        </message>
        <message>
            <source>Flutes</source>
            <translation>Dentes</translation>
        </message>
        <message>
            <source>Font</source>
            <translation>Fonte</translation>
        </message>
        <message>
            <source>Font file</source>
            <translation>Arquivo da fonte</translation>
        </message>
        <message>
            <source>For a mill that does not cut over its centre; 0: 10°</source>
            <translation>Para uma fresa sem corte no centro; 0: 10°</translation>
        </message>
        <message>
            <source>Form</source>
            <translation>Forma</translation>
        </message>
        <message>
            <source>Free length</source>
            <translation>Comprimento livre</translation>
        </message>
        <message>
            <source>From</source>
            <translation>De</translation>
        </message>
        <message>
            <source>From Chart</source>
            <translation>Da tabela</translation>
        </message>
        <message>
            <source>From X to the ellipse's first axis</source>
            <translation>De X até o primeiro eixo da elipse</translation>
        </message>
        <message>
            <source>From X to the first hole, counter-clockwise</source>
            <translation>De X ao primeiro furo, no sentido anti-horário</translation>
        </message>
        <message>
            <source>From X to the last hole</source>
            <translation>De X ao último furo</translation>
        </message>
        <message>
            <source>From X to the lines of the pattern</source>
            <translation>De X às linhas do padrão</translation>
        </message>
        <message>
            <source>From chart</source>
            <translation>Da tabela</translation>
        </message>
        <message>
            <source>From here down the tool feeds</source>
            <translation>Daqui para baixo a ferramenta avança em velocidade de corte</translation>
        </message>
        <message>
            <source>From hole to hole along X and along Y</source>
            <translation>De furo a furo ao longo de X e ao longo de Y</translation>
        </message>
        <message>
            <source>From one turn of the thread to the next</source>
            <translation>De uma volta da rosca à seguinte</translation>
        </message>
        <message>
            <source>From the middle of the circle to the holes</source>
            <translation>Do meio do círculo até os furos</translation>
        </message>
        <message>
            <source>From the tip to the holder; 0: not given</source>
            <translation>Da ponta ao porta-ferramenta; 0: não informado</translation>
        </message>
        <message>
            <source>Gaps up to this are closed</source>
            <translation>Vãos até isto são fechados</translation>
        </message>
        <message>
            <source>Good Side</source>
            <translation>Lado bom</translation>
        </message>
        <message>
            <source>Good side</source>
            <translation>Lado bom</translation>
        </message>
        <message>
            <source>Greatest chip load</source>
            <translation>Avanço por dente máximo</translation>
        </message>
        <message>
            <source>Greatest engagement</source>
            <translation>Ângulo de contato máximo</translation>
        </message>
        <message>
            <source>Half the width along its second axis</source>
            <translation>Metade da largura ao longo do segundo eixo</translation>
        </message>
        <message>
            <source>Half the width along the ellipse's first axis</source>
            <translation>Metade da largura ao longo do primeiro eixo da elipse</translation>
        </message>
        <message>
            <source>Half the width of the pocket</source>
            <translation>Metade da largura do bolsão</translation>
        </message>
        <message>
            <source>Hand</source>
            <translation>Sentido da rosca</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>Altura</translation>
        </message>
        <message>
            <source>Height of</source>
            <translation>Altura de</translation>
        </message>
        <message>
            <source>Heights</source>
            <translation>Alturas</translation>
        </message>
        <message>
            <source>Holder Diameter</source>
            <translation>Diâmetro do porta-ferramenta</translation>
        </message>
        <message>
            <source>Holder diameter</source>
            <translation>Diâmetro do porta-ferramenta</translation>
        </message>
        <message>
            <source>Holes</source>
            <translation>Furos</translation>
        </message>
        <message>
            <source>Holes below</source>
            <translation>Furos abaixo de</translation>
        </message>
        <message>
            <source>Holes of a smaller diameter are cut slowly; 0: none by diameter</source>
            <translation>Furos de diâmetro menor são cortados devagar; 0: nenhum pelo diâmetro</translation>
        </message>
        <message>
            <source>Holes of a smaller diameter get a spot at their centre, no cut</source>
            <translation>Furos de diâmetro menor recebem um ponto no centro, sem corte</translation>
        </message>
        <message>
            <source>Holes with a shorter outline are cut slowly; 0: none by length</source>
            <translation>Furos de contorno mais curto são cortados devagar; 0: nenhum pelo comprimento</translation>
        </message>
        <message>
            <source>How deep a knife or point goes; 0: through the sheet, a point 0.2 mm</source>
            <translation>A profundidade de faca ou ponta; 0: através da chapa, a ponta 0,2 mm</translation>
        </message>
        <message>
            <source>How deep one peck goes</source>
            <translation>Quanto desce cada bicada</translation>
        </message>
        <message>
            <source>How far a closed cut is followed with power beyond its begin</source>
            <translation>Quanto um corte fechado segue com potência além do início</translation>
        </message>
        <message>
            <source>How far a closed line is followed beyond its begin</source>
            <translation>Quanto se segue uma linha fechada além do seu começo</translation>
        </message>
        <message>
            <source>How far a drag knife's edge trails behind its axis</source>
            <translation>Quanto o fio da faca de arrasto fica atrás do seu eixo</translation>
        </message>
        <message>
            <source>How far a pierce stays from parts and cut edges; 0: that of the cut chart</source>
            <translation>Quanto a perfuração se afasta de peças e bordas cortadas; 0: o da tabela de corte</translation>
        </message>
        <message>
            <source>How far above it the letters stand</source>
            <translation>A que distância acima dela ficam as letras</translation>
        </message>
        <message>
            <source>How far an arc turns, or how far a line leans away from the contour</source>
            <translation>Quanto um arco gira, ou quanto uma linha se afasta do contorno</translation>
        </message>
        <message>
            <source>How far apart joints are at most</source>
            <translation>A maior distância entre as pontes</translation>
        </message>
        <message>
            <source>How far apart tabs are at most</source>
            <translation>A distância máxima entre as pontes</translation>
        </message>
        <message>
            <source>How far before and behind a corner</source>
            <translation>Quanto antes e depois de um canto</translation>
        </message>
        <message>
            <source>How far before and behind a corner the feed is lower; 0: it is not</source>
            <translation>Até que distância antes e depois do canto o avanço é menor; 0: não é</translation>
        </message>
        <message>
            <source>How far before its end the cut runs on without power</source>
            <translation>A que distância do fim o corte segue sem potência</translation>
        </message>
        <message>
            <source>How far behind the pierce the power is full</source>
            <translation>A que distância da perfuração a potência é plena</translation>
        </message>
        <message>
            <source>How far from the stock's edge cuts must stay; 0: the edge does not matter</source>
            <translation>A que distância da borda do bloco os cortes devem ficar; 0: a borda não importa</translation>
        </message>
        <message>
            <source>How far letters lean to the right</source>
            <translation>Quanto as letras se inclinam para a direita</translation>
        </message>
        <message>
            <source>How far lines and arcs may leave other curves</source>
            <translation>Quanto linhas e arcos podem se afastar de outras curvas</translation>
        </message>
        <message>
            <source>How far lines and arcs may leave the letters</source>
            <translation>Quanto linhas e arcos podem se afastar das letras</translation>
        </message>
        <message>
            <source>How far lines and arcs may leave the pixels; 0: half a pixel</source>
            <translation>Quanto linhas e arcos podem se afastar dos pixels; 0: meio pixel</translation>
        </message>
        <message>
            <source>How far one turn of the helix falls</source>
            <translation>Quanto desce uma volta da hélice</translation>
        </message>
        <message>
            <source>How far the arc goes; below 0 clockwise, with the letters outside</source>
            <translation>Até onde vai o arco; abaixo de 0 no sentido horário, com as letras por fora</translation>
        </message>
        <message>
            <source>How far the cut may be off the drawing</source>
            <translation>Quanto o corte pode se afastar do desenho</translation>
        </message>
        <message>
            <source>How far the kerf of a way through the scrap stays from every part</source>
            <translation>Quanto o corte de um caminho pelo retalho se afasta de cada peça</translation>
        </message>
        <message>
            <source>How far the path may be off an ellipse or a B-spline; lines and arcs are exact</source>
            <translation>Quanto a trajetória pode desviar de uma elipse ou B-spline; retas e arcos são exatos</translation>
        </message>
        <message>
            <source>How far the tool's rim runs over the edge</source>
            <translation>Quanto a borda da ferramenta passa da aresta</translation>
        </message>
        <message>
            <source>How far the torch runs on over the begin of the cut without power</source>
            <translation>Quanto a tocha segue sobre o início do corte sem potência</translation>
        </message>
        <message>
            <source>How far the wall may be off the drawing</source>
            <translation>Quanto a parede pode se afastar do desenho</translation>
        </message>
        <message>
            <source>How high a tab is above the bottom of the cut</source>
            <translation>A altura de uma ponte acima do fundo do corte</translation>
        </message>
        <message>
            <source>How it is cut; the machine must be able to</source>
            <translation>Como se corta; a máquina precisa ser capaz disso</translation>
        </message>
        <message>
            <source>How it was read last</source>
            <translation>Como foi lido por último</translation>
        </message>
        <message>
            <source>How long a spot has power</source>
            <translation>Quanto tempo um ponto tem potência</translation>
        </message>
        <message>
            <source>How long the flame heats before the pierce; 0: that of the chart</source>
            <translation>Quanto tempo a chama aquece antes da perfuração; 0: o da tabela</translation>
        </message>
        <message>
            <source>How many corners and narrow places the tool does not reach into</source>
            <translation>Em quantos cantos e lugares estreitos a ferramenta não entra</translation>
        </message>
        <message>
            <source>How many gaps, doubles, crossings and other faults were found</source>
            <translation>Quantos vãos, duplicadas, cruzamentos e outras falhas foram achados</translation>
        </message>
        <message>
            <source>How many holes</source>
            <translation>Quantos furos</translation>
        </message>
        <message>
            <source>How many holes along X</source>
            <translation>Quantos furos ao longo de X</translation>
        </message>
        <message>
            <source>How many holes along Y</source>
            <translation>Quantos furos ao longo de Y</translation>
        </message>
        <message>
            <source>How many holes are made</source>
            <translation>Quantos furos são feitos</translation>
        </message>
        <message>
            <source>How many joints on each outline</source>
            <translation>Quantas pontes em cada contorno</translation>
        </message>
        <message>
            <source>How many parts are cut free</source>
            <translation>Quantas peças são soltas</translation>
        </message>
        <message>
            <source>How many passes at each depth</source>
            <translation>Número de passes em cada profundidade</translation>
        </message>
        <message>
            <source>How many passes in depth</source>
            <translation>Número de passes em profundidade</translation>
        </message>
        <message>
            <source>How many points the wire has</source>
            <translation>Número de pontos do arame</translation>
        </message>
        <message>
            <source>How many tabs hold the part</source>
            <translation>Quantas pontes seguram a peça</translation>
        </message>
        <message>
            <source>How many tabs on each line</source>
            <translation>Quantas pontes em cada linha</translation>
        </message>
        <message>
            <source>How many teeth; 0: not given</source>
            <translation>Quantos dentes; 0: não informado</translation>
        </message>
        <message>
            <source>How many there are</source>
            <translation>Quantos há</translation>
        </message>
        <message>
            <source>How many there are: one, or one a tool in turn</source>
            <translation>Quantos são: um, ou um por ferramenta na sequência</translation>
        </message>
        <message>
            <source>How many turns the thread has</source>
            <translation>Quantas voltas a rosca tem</translation>
        </message>
        <message>
            <source>How much of the rim may be in the material at most, as an angle</source>
            <translation>Quanto da borda pode estar no material no máximo, como ângulo</translation>
        </message>
        <message>
            <source>How much of the rim may be in the material, as an angle; 0: not given</source>
            <translation>Quanto do contorno pode estar no material, em ângulo; 0: não informado</translation>
        </message>
        <message>
            <source>How often each line is cut</source>
            <translation>Quantas vezes cada linha é cortada</translation>
        </message>
        <message>
            <source>How often the tool pierces</source>
            <translation>Quantas vezes a ferramenta perfura</translation>
        </message>
        <message>
            <source>How steeply a helix or ramp goes down</source>
            <translation>Inclinação com que a hélice ou rampa desce</translation>
        </message>
        <message>
            <source>How steeply the tool goes down along the line; 0: straight down</source>
            <translation>Com que inclinação a ferramenta desce ao longo da linha; 0: na vertical</translation>
        </message>
        <message>
            <source>How the area is cleared</source>
            <translation>Como a área é esvaziada</translation>
        </message>
        <message>
            <source>How the cutter turns against the feed</source>
            <translation>Como a fresa gira em relação ao avanço</translation>
        </message>
        <message>
            <source>How the drill goes down</source>
            <translation>Como a broca desce</translation>
        </message>
        <message>
            <source>How the thread winds</source>
            <translation>Para que lado a rosca gira</translation>
        </message>
        <message>
            <source>How the tool comes to the contour</source>
            <translation>Como a ferramenta chega ao contorno</translation>
        </message>
        <message>
            <source>How the tool goes down</source>
            <translation>Como a ferramenta desce</translation>
        </message>
        <message>
            <source>How the tool leaves the contour</source>
            <translation>Como a ferramenta deixa o contorno</translation>
        </message>
        <message>
            <source>How wide a tab is at its top</source>
            <translation>A largura de uma ponte no topo</translation>
        </message>
        <message>
            <source>How wide the material is that stays</source>
            <translation>A largura do material que fica</translation>
        </message>
        <message>
            <source>Identity</source>
            <translation>Identidade</translation>
        </message>
        <message>
            <source>In holes, or round bosses</source>
            <translation>Em furos ou em volta de ressaltos</translation>
        </message>
        <message>
            <source>In how many steps outwards</source>
            <translation>Em quantos passos para fora</translation>
        </message>
        <message>
            <source>In the program</source>
            <translation>No programa</translation>
        </message>
        <message>
            <source>In whole passes</source>
            <translation>Em passes inteiros</translation>
        </message>
        <message>
            <source>Invert</source>
            <translation>Inverter</translation>
        </message>
        <message>
            <source>Its name in job files</source>
            <translation>Seu nome nos arquivos de trabalho</translation>
        </message>
        <message>
            <source>Job</source>
            <translation>Trabalho</translation>
        </message>
        <message>
            <source>Join</source>
            <translation>Unir</translation>
        </message>
        <message>
            <source>Join ends</source>
            <translation>Unir pontas</translation>
        </message>
        <message>
            <source>Join only lines of one colour</source>
            <translation>Unir só linhas da mesma cor</translation>
        </message>
        <message>
            <source>Joints that hold the part until it is broken out</source>
            <translation>Pontes que seguram a peça até ela ser destacada</translation>
        </message>
        <message>
            <source>Kept</source>
            <translation>Pontos mantidos</translation>
        </message>
        <message>
            <source>Kerf</source>
            <translation>Largura do corte</translation>
        </message>
        <message>
            <source>Kerf Used</source>
            <translation>Largura de corte usada</translation>
        </message>
        <message>
            <source>Kerning</source>
            <translation>Kerning</translation>
        </message>
        <message>
            <source>Kind</source>
            <translation>Tipo</translation>
        </message>
        <message>
            <source>Last hole</source>
            <translation>Último furo</translation>
        </message>
        <message>
            <source>Last stepdown</source>
            <translation>Última profundidade de corte</translation>
        </message>
        <message>
            <source>Last stepover</source>
            <translation>Última penetração de trabalho</translation>
        </message>
        <message>
            <source>Lead In Angle</source>
            <translation>Ângulo de entrada</translation>
        </message>
        <message>
            <source>Lead In By</source>
            <translation>Regra das entradas</translation>
        </message>
        <message>
            <source>Lead In Kind</source>
            <translation>Tipo de entrada</translation>
        </message>
        <message>
            <source>Lead In Length</source>
            <translation>Comprimento de entrada</translation>
        </message>
        <message>
            <source>Lead In Radius</source>
            <translation>Raio de entrada</translation>
        </message>
        <message>
            <source>Lead Out Angle</source>
            <translation>Ângulo de saída</translation>
        </message>
        <message>
            <source>Lead Out Kind</source>
            <translation>Tipo de saída</translation>
        </message>
        <message>
            <source>Lead Out Length</source>
            <translation>Comprimento de saída</translation>
        </message>
        <message>
            <source>Lead Out Radius</source>
            <translation>Raio de saída</translation>
        </message>
        <message>
            <source>Lead-in</source>
            <translation>Entrada</translation>
        </message>
        <message>
            <source>Lead-out</source>
            <translation>Saída</translation>
        </message>
        <message>
            <source>Leads</source>
            <translation>Entrada e saída</translation>
        </message>
        <message>
            <source>Leads as usual for the process, or with values of your own</source>
            <translation>Entradas e saídas usuais do processo, ou com valores próprios</translation>
        </message>
        <message>
            <source>Least chip load</source>
            <translation>Avanço por dente mínimo</translation>
        </message>
        <message>
            <source>Leave</source>
            <translation>Sai</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>Comprimento livre</translation>
        </message>
        <message>
            <source>Length Offset</source>
            <translation>Correção de comprimento</translation>
        </message>
        <message>
            <source>Length in</source>
            <translation>Comprimento entrada</translation>
        </message>
        <message>
            <source>Length offset</source>
            <translation>Correção de comprimento</translation>
        </message>
        <message>
            <source>Length out</source>
            <translation>Comprimento saída</translation>
        </message>
        <message>
            <source>Length that the controller adds to Z, if the machine uses a table of lengths; 0: not given</source>
            <translation>O que o controlador soma a Z, onde a máquina toma os comprimentos de uma tabela; 0: não informado</translation>
        </message>
        <message>
            <source>Length, width and height; for an upright cylinder the length is its diameter</source>
            <translation>Comprimento, largura e altura; num cilindro, que fica em pé, o comprimento é o diâmetro</translation>
        </message>
        <message>
            <source>Lengths and limits</source>
            <translation>Comprimentos e limites</translation>
        </message>
        <message>
            <source>Levels</source>
            <translation>Níveis</translation>
        </message>
        <message>
            <source>Light areas</source>
            <translation>Áreas claras</translation>
        </message>
        <message>
            <source>Line</source>
            <translation>Linha</translation>
        </message>
        <message>
            <source>Line Begin</source>
            <translation>Início da linha</translation>
        </message>
        <message>
            <source>Line End</source>
            <translation>Fim da linha</translation>
        </message>
        <message>
            <source>Line Length</source>
            <translation>Comprimento das linhas</translation>
        </message>
        <message>
            <source>Line Spacing</source>
            <translation>Entrelinha</translation>
        </message>
        <message>
            <source>Line length</source>
            <translation>Comprimento das linhas</translation>
        </message>
        <message>
            <source>Line spacing</source>
            <translation>Entrelinha</translation>
        </message>
        <message>
            <source>Lines</source>
            <translation>Linhas</translation>
        </message>
        <message>
            <source>Lines nearer than this to another one are drawn twice</source>
            <translation>Linhas mais próximas de outra que isto estão desenhadas duas vezes</translation>
        </message>
        <message>
            <source>Lines of many points become fewer lines and arcs within this; 0: they stay</source>
            <translation>Linhas de muitos pontos viram menos linhas e arcos dentro disto; 0: ficam</translation>
        </message>
        <message>
            <source>Lines that are marked with low power or lightly scribed before anything is cut</source>
            <translation>Linhas marcadas com pouca potência ou levemente riscadas antes de qualquer corte</translation>
        </message>
        <message>
            <source>Lines up to this long are left out</source>
            <translation>Linhas até este comprimento são deixadas de fora</translation>
        </message>
        <message>
            <source>Loop radius</source>
            <translation>Raio do laço</translation>
        </message>
        <message>
            <source>Loops</source>
            <translation>Laços</translation>
        </message>
        <message>
            <source>Loops Angle</source>
            <translation>Ângulo dos laços</translation>
        </message>
        <message>
            <source>Loops By</source>
            <translation>Regra dos laços</translation>
        </message>
        <message>
            <source>Loops Radius</source>
            <translation>Raio dos laços</translation>
        </message>
        <message>
            <source>Loops above</source>
            <translation>Laços acima de</translation>
        </message>
        <message>
            <source>Loops in the scrap, which make outside corners sharp</source>
            <translation>Laços no retalho, que deixam vivos os cantos externos</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>Máquina</translation>
        </message>
        <message>
            <source>Made From</source>
            <translation>Feito a partir de</translation>
        </message>
        <message>
            <source>Made Of</source>
            <translation>Feita de</translation>
        </message>
        <message>
            <source>Made from</source>
            <translation>Feito a partir de</translation>
        </message>
        <message>
            <source>Made of</source>
            <translation>Feita de</translation>
        </message>
        <message>
            <source>Major</source>
            <translation>Maior</translation>
        </message>
        <message>
            <source>Major Diameter</source>
            <translation>Diâmetro maior</translation>
        </message>
        <message>
            <source>Margin</source>
            <translation>Margem</translation>
        </message>
        <message>
            <source>Mark Drawings</source>
            <translation>Desenhos de marcação</translation>
        </message>
        <message>
            <source>Mark Feed</source>
            <translation>Avanço de marcação</translation>
        </message>
        <message>
            <source>Mark Power</source>
            <translation>Potência de marcação</translation>
        </message>
        <message>
            <source>Marking feed</source>
            <translation>Avanço de marcação</translation>
        </message>
        <message>
            <source>Marking power</source>
            <translation>Potência de marcação</translation>
        </message>
        <message>
            <source>Marks</source>
            <translation>Marcações</translation>
        </message>
        <message>
            <source>Material</source>
            <translation>Material</translation>
        </message>
        <message>
            <source>Material of the cutter</source>
            <translation>De que a ferramenta é feita</translation>
        </message>
        <message>
            <source>Material that a round tool leaves at the ends of the long axis</source>
            <translation>O que a ferramenta redonda deixa nas pontas do eixo maior</translation>
        </message>
        <message>
            <source>Mend</source>
            <translation>Reparar</translation>
        </message>
        <message>
            <source>Message</source>
            <translation>Mensagem</translation>
        </message>
        <message>
            <source>Method</source>
            <translation>Método</translation>
        </message>
        <message>
            <source>Minor</source>
            <translation>Menor</translation>
        </message>
        <message>
            <source>Minor Diameter</source>
            <translation>Diâmetro menor</translation>
        </message>
        <message>
            <source>Minor Used</source>
            <translation>Diâmetro menor usado</translation>
        </message>
        <message>
            <source>Narrow arcs</source>
            <translation>Arcos estreitos</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>Observação</translation>
        </message>
        <message>
            <source>Nozzle, lens, wire or blade; empty: the first of the chart for this thickness</source>
            <translation>Bico, lente, fio ou lâmina; vazio: o primeiro da tabela para esta espessura</translation>
        </message>
        <message>
            <source>Number</source>
            <translation>Número</translation>
        </message>
        <message>
            <source>Objects</source>
            <translation>Objetos</translation>
        </message>
        <message>
            <source>Of a bull nose; 0: not given</source>
            <translation>De uma fresa toroidal; 0: não informado</translation>
        </message>
        <message>
            <source>Of its curves</source>
            <translation>De suas curvas</translation>
        </message>
        <message>
            <source>Of one wall that a jet or wire leaves, against the vertical; 0: none</source>
            <translation>De uma parede deixada pelo jato ou fio, em relação à vertical; 0: nenhuma</translation>
        </message>
        <message>
            <source>Of the arc</source>
            <translation>Do arco</translation>
        </message>
        <message>
            <source>Of the bores; 0: that of each circle of the drawing</source>
            <translation>Dos furos; 0: o de cada círculo do desenho</translation>
        </message>
        <message>
            <source>Of the capitals, or of the em</source>
            <translation>Das maiúsculas, ou do corpo da fonte</translation>
        </message>
        <message>
            <source>Of the corners seen from above; 0: as round as the tool</source>
            <translation>Dos cantos vistos de cima; 0: tão redondos quanto a ferramenta</translation>
        </message>
        <message>
            <source>Of the font, such as Bold; empty: the regular one</source>
            <translation>Da fonte, como Bold; vazio: o normal</translation>
        </message>
        <message>
            <source>Of the grid about its first hole</source>
            <translation>Da grade em torno do seu primeiro furo</translation>
        </message>
        <message>
            <source>Of the written program</source>
            <translation>Do programa gerado</translation>
        </message>
        <message>
            <source>On which side of the cut the part lies, seen along it</source>
            <translation>De que lado do corte fica a peça, visto ao longo dele</translation>
        </message>
        <message>
            <source>On which side of the lines the tool runs</source>
            <translation>De que lado das linhas a ferramenta corre</translation>
        </message>
        <message>
            <source>One end of the diagonal, from the work zero</source>
            <translation>Uma ponta da diagonal, a partir do zero da peça</translation>
        </message>
        <message>
            <source>One hole at each point</source>
            <translation>Um furo em cada ponto</translation>
        </message>
        <message>
            <source>Operation</source>
            <translation>Operação</translation>
        </message>
        <message>
            <source>Operations</source>
            <translation>Operações</translation>
        </message>
        <message>
            <source>Order</source>
            <translation>Ordem</translation>
        </message>
        <message>
            <source>Other corner</source>
            <translation>Outro canto</translation>
        </message>
        <message>
            <source>Outlines of the clamps</source>
            <translation>Contornos dos grampos</translation>
        </message>
        <message>
            <source>Outputs that are on while cutting</source>
            <translation>O que fica ligado durante o corte</translation>
        </message>
        <message>
            <source>Outside corners that turn by more get a loop</source>
            <translation>Cantos externos que viram mais recebem um laço</translation>
        </message>
        <message>
            <source>Over-burn</source>
            <translation>Ultrapassagem</translation>
        </message>
        <message>
            <source>Overcut</source>
            <translation>Sobrecorte</translation>
        </message>
        <message>
            <source>Overhang</source>
            <translation>Passagem da borda</translation>
        </message>
        <message>
            <source>Pairs of letters stand as near as the font says</source>
            <translation>Pares de letras ficam tão próximos quanto a fonte diz</translation>
        </message>
        <message>
            <source>Part</source>
            <translation>Parte</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Peças</translation>
        </message>
        <message>
            <source>Passes</source>
            <translation>Passes</translation>
        </message>
        <message>
            <source>Path</source>
            <translation>Trajetória</translation>
        </message>
        <message>
            <source>Pattern</source>
            <translation>Padrão</translation>
        </message>
        <message>
            <source>Pause</source>
            <translation>Pausa</translation>
        </message>
        <message>
            <source>Pause of the wire where the path turns back; shorter at blunter corners</source>
            <translation>Quanto tempo o fio para onde o caminho volta; menos em cantos mais abertos</translation>
        </message>
        <message>
            <source>Peck</source>
            <translation>Bicada</translation>
        </message>
        <message>
            <source>Picture</source>
            <translation>Imagem</translation>
        </message>
        <message>
            <source>Pierce</source>
            <translation>Perfuração</translation>
        </message>
        <message>
            <source>Pierce Delay</source>
            <translation>Espera na perfuração</translation>
        </message>
        <message>
            <source>Pierce Height</source>
            <translation>Altura de perfuração</translation>
        </message>
        <message>
            <source>Pierce delay</source>
            <translation>Espera na perfuração</translation>
        </message>
        <message>
            <source>Pierce distance</source>
            <translation>Distância da perfuração</translation>
        </message>
        <message>
            <source>Pierce height</source>
            <translation>Altura de perfuração</translation>
        </message>
        <message>
            <source>Pierces</source>
            <translation>Perfurações</translation>
        </message>
        <message>
            <source>Pitch</source>
            <translation>Passo</translation>
        </message>
        <message>
            <source>Pixels an inch; 0: as the file says</source>
            <translation>Pixels por polegada; 0: como o arquivo diz</translation>
        </message>
        <message>
            <source>Place Centre</source>
            <translation>Centro dos lugares</translation>
        </message>
        <message>
            <source>Place Columns</source>
            <translation>Colunas</translation>
        </message>
        <message>
            <source>Place Count</source>
            <translation>Quantidade de lugares</translation>
        </message>
        <message>
            <source>Place End</source>
            <translation>Último lugar</translation>
        </message>
        <message>
            <source>Place End Angle</source>
            <translation>Ângulo final</translation>
        </message>
        <message>
            <source>Place Origin</source>
            <translation>Origem da grade</translation>
        </message>
        <message>
            <source>Place Points</source>
            <translation>Pontos</translation>
        </message>
        <message>
            <source>Place Radius</source>
            <translation>Raio dos lugares</translation>
        </message>
        <message>
            <source>Place Rotation</source>
            <translation>Rotação da grade</translation>
        </message>
        <message>
            <source>Place Rows</source>
            <translation>Linhas da grade</translation>
        </message>
        <message>
            <source>Place Spacing</source>
            <translation>Espaçamento da grade</translation>
        </message>
        <message>
            <source>Place Start</source>
            <translation>Primeiro lugar</translation>
        </message>
        <message>
            <source>Place Start Angle</source>
            <translation>Ângulo inicial</translation>
        </message>
        <message>
            <source>Places</source>
            <translation>Lugares</translation>
        </message>
        <message>
            <source>Plunge</source>
            <translation>Mergulho</translation>
        </message>
        <message>
            <source>Plunge Used</source>
            <translation>Mergulho usado</translation>
        </message>
        <message>
            <source>Plunge feed</source>
            <translation>Avanço de mergulho</translation>
        </message>
        <message>
            <source>Point Angle</source>
            <translation>Ângulo da broca</translation>
        </message>
        <message>
            <source>Point angle</source>
            <translation>Ângulo da broca</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Pontos</translation>
        </message>
        <message>
            <source>Points kept</source>
            <translation>Pontos mantidos</translation>
        </message>
        <message>
            <source>Power</source>
            <translation>Potência</translation>
        </message>
        <message>
            <source>Power Ramp Begin Share</source>
            <translation>Início da rampa de potência</translation>
        </message>
        <message>
            <source>Power Ramp By</source>
            <translation>Regra da rampa de potência</translation>
        </message>
        <message>
            <source>Power Ramp Length</source>
            <translation>Comprimento da rampa de potência</translation>
        </message>
        <message>
            <source>Power on before the tool moves; 0: that of the chart</source>
            <translation>Tempo ligado antes de a ferramenta se mover; 0: o da tabela</translation>
        </message>
        <message>
            <source>Power ramp</source>
            <translation>Rampa de potência</translation>
        </message>
        <message>
            <source>Preheat</source>
            <translation>Pré-aquecimento</translation>
        </message>
        <message>
            <source>Preview</source>
            <translation>Prévia</translation>
        </message>
        <message>
            <source>Problem</source>
            <translation>Problema</translation>
        </message>
        <message>
            <source>Process</source>
            <translation>Processo</translation>
        </message>
        <message>
            <source>Profile</source>
            <translation>Perfil</translation>
        </message>
        <message>
            <source>Program</source>
            <translation>Programa</translation>
        </message>
        <message>
            <source>Program Part</source>
            <translation>Parte do programa</translation>
        </message>
        <message>
            <source>Program Parts</source>
            <translation>Partes do programa</translation>
        </message>
        <message>
            <source>Program number</source>
            <translation>Número do programa</translation>
        </message>
        <message>
            <source>Programs</source>
            <translation>Programas</translation>
        </message>
        <message>
            <source>Radial Passes</source>
            <translation>Passes radiais</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>Raio</translation>
        </message>
        <message>
            <source>Radius X</source>
            <translation>Semieixo X</translation>
        </message>
        <message>
            <source>Radius Y</source>
            <translation>Semieixo Y</translation>
        </message>
        <message>
            <source>Radius in</source>
            <translation>Raio entrada</translation>
        </message>
        <message>
            <source>Radius in pixels of a blur that takes out noise</source>
            <translation>Raio em pixels de um desfoque que tira o ruído</translation>
        </message>
        <message>
            <source>Radius out</source>
            <translation>Raio saída</translation>
        </message>
        <message>
            <source>Radius x</source>
            <translation>Semieixo x</translation>
        </message>
        <message>
            <source>Radius y</source>
            <translation>Semieixo y</translation>
        </message>
        <message>
            <source>Ramp</source>
            <translation>Rampa</translation>
        </message>
        <message>
            <source>Ramp Max</source>
            <translation>Rampa máxima</translation>
        </message>
        <message>
            <source>Ramp begin</source>
            <translation>Início da rampa</translation>
        </message>
        <message>
            <source>Ramp length</source>
            <translation>Comprimento da rampa</translation>
        </message>
        <message>
            <source>Read</source>
            <translation>Lido</translation>
        </message>
        <message>
            <source>Rectangle</source>
            <translation>Retângulo</translation>
        </message>
        <message>
            <source>Region</source>
            <translation>Região</translation>
        </message>
        <message>
            <source>Repair</source>
            <translation>Reparo</translation>
        </message>
        <message>
            <source>Repair what is wrong, as far as these values allow</source>
            <translation>Repara o que está errado, até onde estes valores permitem</translation>
        </message>
        <message>
            <source>Report</source>
            <translation>Relatório</translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation>Resolução</translation>
        </message>
        <message>
            <source>Rest Corner</source>
            <translation>Resto no canto</translation>
        </message>
        <message>
            <source>Rest Corners</source>
            <translation>Cantos com resto</translation>
        </message>
        <message>
            <source>Rest at most</source>
            <translation>Resto máximo</translation>
        </message>
        <message>
            <source>Rest corners</source>
            <translation>Cantos com resto</translation>
        </message>
        <message>
            <source>Result</source>
            <translation>Resultado</translation>
        </message>
        <message>
            <source>Retract</source>
            <translation>Retração</translation>
        </message>
        <message>
            <source>Retract To</source>
            <translation>Recuar até</translation>
        </message>
        <message>
            <source>Retract to</source>
            <translation>Recuar até</translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation>Rotação</translation>
        </message>
        <message>
            <source>Rows</source>
            <translation>Linhas</translation>
        </message>
        <message>
            <source>Rules</source>
            <translation>Regras</translation>
        </message>
        <message>
            <source>Seconds at the bottom</source>
            <translation>Segundos no fundo</translation>
        </message>
        <message>
            <source>Section</source>
            <translation>Seção</translation>
        </message>
        <message>
            <source>Setting</source>
            <translation>Composição</translation>
        </message>
        <message>
            <source>Shape</source>
            <translation>Forma</translation>
        </message>
        <message>
            <source>Shape Kind</source>
            <translation>Tipo de forma</translation>
        </message>
        <message>
            <source>Shape of the raw material</source>
            <translation>Como é a matéria-prima</translation>
        </message>
        <message>
            <source>Shorter than</source>
            <translation>Mais curtos que</translation>
        </message>
        <message>
            <source>Side</source>
            <translation>Lado</translation>
        </message>
        <message>
            <source>Simplify</source>
            <translation>Simplificar</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Tamanho</translation>
        </message>
        <message>
            <source>Slant</source>
            <translation>Inclinação</translation>
        </message>
        <message>
            <source>Small Holes By</source>
            <translation>Regra dos furos pequenos</translation>
        </message>
        <message>
            <source>Small Holes Diameter</source>
            <translation>Diâmetro dos furos pequenos</translation>
        </message>
        <message>
            <source>Small Holes Feed Share</source>
            <translation>Parte do avanço nos furos pequenos</translation>
        </message>
        <message>
            <source>Small Holes Length</source>
            <translation>Comprimento dos furos pequenos</translation>
        </message>
        <message>
            <source>Small Holes Over Run</source>
            <translation>Ultrapassagem dos furos pequenos</translation>
        </message>
        <message>
            <source>Small Holes Thickness Ratio</source>
            <translation>Furos pequenos por espessura</translation>
        </message>
        <message>
            <source>Small Holes Torch Off</source>
            <translation>Desligar antes nos furos pequenos</translation>
        </message>
        <message>
            <source>Small holes</source>
            <translation>Furos pequenos</translation>
        </message>
        <message>
            <source>Small holes at a feed of their own</source>
            <translation>Furos pequenos com avanço próprio</translation>
        </message>
        <message>
            <source>Smaller areas, in mm², are left out; 0: four pixels</source>
            <translation>Áreas menores, em mm², são deixadas de fora; 0: quatro pixels</translation>
        </message>
        <message>
            <source>Smooth</source>
            <translation>Suavizar</translation>
        </message>
        <message>
            <source>Solids that hold the work down, which the tool must not touch</source>
            <translation>Sólidos que prendem a peça e em que a ferramenta não pode tocar</translation>
        </message>
        <message>
            <source>Spacing</source>
            <translation>Espaçamento</translation>
        </message>
        <message>
            <source>Speck</source>
            <translation>Mancha</translation>
        </message>
        <message>
            <source>Specks</source>
            <translation>Manchas</translation>
        </message>
        <message>
            <source>Spindle</source>
            <translation>Spindle</translation>
        </message>
        <message>
            <source>Spindle Speed</source>
            <translation>Rotação do spindle</translation>
        </message>
        <message>
            <source>Spindle Used</source>
            <translation>Rotação usada</translation>
        </message>
        <message>
            <source>Spindle turns a minute; 0: those of the job's material</source>
            <translation>Rotações do spindle por minuto; 0: as do material do trabalho</translation>
        </message>
        <message>
            <source>Split</source>
            <translation>Divisão</translation>
        </message>
        <message>
            <source>Spot</source>
            <translation>Ponto</translation>
        </message>
        <message>
            <source>Spot Below</source>
            <translation>Marcar abaixo de</translation>
        </message>
        <message>
            <source>Spot holes below</source>
            <translation>Marca furos abaixo de</translation>
        </message>
        <message>
            <source>Spot time</source>
            <translation>Tempo do ponto</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Iniciar</translation>
        </message>
        <message>
            <source>Start angle</source>
            <translation>Ângulo inicial</translation>
        </message>
        <message>
            <source>State</source>
            <translation>Estado</translation>
        </message>
        <message>
            <source>Steepest ramp</source>
            <translation>Rampa máxima</translation>
        </message>
        <message>
            <source>Stepdown</source>
            <translation>Profundidade de corte</translation>
        </message>
        <message>
            <source>Stepdown Used</source>
            <translation>Profundidade de corte usada</translation>
        </message>
        <message>
            <source>Stepdown ap</source>
            <translation>Profundidade de corte ap</translation>
        </message>
        <message>
            <source>Stepover</source>
            <translation>Penetração de trabalho</translation>
        </message>
        <message>
            <source>Stepover Used</source>
            <translation>Penetração de trabalho usada</translation>
        </message>
        <message>
            <source>Stepover ae</source>
            <translation>Penetração de trabalho ae</translation>
        </message>
        <message>
            <source>Stock</source>
            <translation>Bloco</translation>
        </message>
        <message>
            <source>Stock Form</source>
            <translation>Forma do bloco</translation>
        </message>
        <message>
            <source>Stock Origin</source>
            <translation>Origem no bloco</translation>
        </message>
        <message>
            <source>Stock Size</source>
            <translation>Tamanho do bloco</translation>
        </message>
        <message>
            <source>Stock To Leave</source>
            <translation>Sobremetal</translation>
        </message>
        <message>
            <source>Stock to leave</source>
            <translation>Sobremetal</translation>
        </message>
        <message>
            <source>Stock to leave at the wall for another operation</source>
            <translation>O que fica na parede para outra operação tirar</translation>
        </message>
        <message>
            <source>Style</source>
            <translation>Estilo</translation>
        </message>
        <message>
            <source>Sweep</source>
            <translation>Abertura</translation>
        </message>
        <message>
            <source>Tabs</source>
            <translation>Pontes</translation>
        </message>
        <message>
            <source>Tabs By</source>
            <translation>Pontes por</translation>
        </message>
        <message>
            <source>Tabs Count</source>
            <translation>Quantidade de pontes</translation>
        </message>
        <message>
            <source>Tabs Height</source>
            <translation>Altura das pontes</translation>
        </message>
        <message>
            <source>Tabs Made</source>
            <translation>Pontes feitas</translation>
        </message>
        <message>
            <source>Tabs Spacing</source>
            <translation>Espaçamento das pontes</translation>
        </message>
        <message>
            <source>Tabs Width</source>
            <translation>Largura das pontes</translation>
        </message>
        <message>
            <source>Taper</source>
            <translation>Conicidade</translation>
        </message>
        <message>
            <source>Text</source>
            <translation>Texto</translation>
        </message>
        <message>
            <source>The G-code file that it is, which has nothing to do with the operations of its job</source>
            <translation>O arquivo de G-code que ele é, sem relação com as operações do seu trabalho</translation>
        </message>
        <message>
            <source>The T word of the program</source>
            <translation>A palavra T do programa</translation>
        </message>
        <message>
            <source>The centre, from the work zero</source>
            <translation>O centro, a partir do zero-peça</translation>
        </message>
        <message>
            <source>The circles and points of sketches, or the circular edges of solids</source>
            <translation>Os círculos e pontos de esboços, ou as arestas circulares de sólidos</translation>
        </message>
        <message>
            <source>The clamps seen from above, at the height of their tops</source>
            <translation>Os grampos vistos de cima, na altura dos seus topos</translation>
        </message>
        <message>
            <source>The colour in the file</source>
            <translation>A cor no arquivo</translation>
        </message>
        <message>
            <source>The corner where the grid begins, from the work zero</source>
            <translation>O canto onde a grade começa, a partir do zero da peça</translation>
        </message>
        <message>
            <source>The current set at the power source; 0: from the chart</source>
            <translation>O que se ajusta na fonte; 0: a corrente da tabela</translation>
        </message>
        <message>
            <source>The cut chart gives this value; change it in the job</source>
            <translation>A tabela de corte dá este valor; altere-o no trabalho</translation>
        </message>
        <message>
            <source>The depth below the top of the stock</source>
            <translation>A profundidade abaixo do topo do bloco</translation>
        </message>
        <message>
            <source>The depth of one pass at most, ap</source>
            <translation>A profundidade máxima de um passe, ap</translation>
        </message>
        <message>
            <source>The depth of one pass at most; 0: all at once</source>
            <translation>A profundidade máxima de um passe; 0: tudo de uma vez</translation>
        </message>
        <message>
            <source>The diameter at the other end of the flanks; 0: that of a metric thread</source>
            <translation>O diâmetro na outra ponta dos flancos; 0: o de uma rosca métrica</translation>
        </message>
        <message>
            <source>The diameter of the cutter</source>
            <translation>O diâmetro da fresa</translation>
        </message>
        <message>
            <source>The diameter of the tool holder; 0: not given</source>
            <translation>O diâmetro do que segura a ferramenta; 0: não informado</translation>
        </message>
        <message>
            <source>The document and the name of the object itself; a copy still has those of its original</source>
            <translation>O documento e o nome do próprio objeto; uma cópia ainda tem os do original</translation>
        </message>
        <message>
            <source>The drawing gives this value</source>
            <translation>O desenho define este valor</translation>
        </message>
        <message>
            <source>The drawing it followed, when that was deleted</source>
            <translation>O desenho que ela seguia, se foi excluído</translation>
        </message>
        <message>
            <source>The drawing that the objects follow</source>
            <translation>O desenho que os objetos seguem</translation>
        </message>
        <message>
            <source>The edge of the sheet at which the wire enters</source>
            <translation>A borda da chapa por onde o fio entra</translation>
        </message>
        <message>
            <source>The feed of marks; 0: that of the cut</source>
            <translation>O avanço das marcações; 0: o do corte</translation>
        </message>
        <message>
            <source>The feed of the last pass at the wall; 0: the tool's own feed</source>
            <translation>O avanço do último passe na parede; 0: o avanço da própria ferramenta</translation>
        </message>
        <message>
            <source>The feed of the last pass; 0: the tool's own feed</source>
            <translation>O avanço do último passe; 0: o avanço da própria ferramenta</translation>
        </message>
        <message>
            <source>The feed of the program</source>
            <translation>O avanço do programa</translation>
        </message>
        <message>
            <source>The file of a cut chart of your own; empty: the chart that ships</source>
            <translation>O arquivo de uma tabela de corte própria; vazio: a tabela que acompanha o programa</translation>
        </message>
        <message>
            <source>The fingerprint of the job's program from which this one was edited</source>
            <translation>A impressão digital do programa do trabalho a partir do qual este foi editado</translation>
        </message>
        <message>
            <source>The flat at the tip of a V-bit or engraver; 0: it is pointed</source>
            <translation>O plano na ponta de uma fresa em V ou de gravação; 0: ela é pontiaguda</translation>
        </message>
        <message>
            <source>The form of the cutter</source>
            <translation>A forma da fresa</translation>
        </message>
        <message>
            <source>The groups around it in the file</source>
            <translation>Os grupos em volta dele no arquivo</translation>
        </message>
        <message>
            <source>The height of the rapids between holes: G98 or G99</source>
            <translation>A altura dos rápidos entre furos: G98 ou G99</translation>
        </message>
        <message>
            <source>The job whose program is shown</source>
            <translation>O trabalho cujo programa é mostrado</translation>
        </message>
        <message>
            <source>The job with the machine, stock, tools and clamps for the program</source>
            <translation>O trabalho para cuja máquina, bloco, ferramentas e grampos o programa é feito</translation>
        </message>
        <message>
            <source>The last pass at the wall, ae_acab; 0: none</source>
            <translation>O último passe na parede, ae_acab; 0: nenhum</translation>
        </message>
        <message>
            <source>The last pass in depth, ap_acab; 0: none</source>
            <translation>O último passe em profundidade, ap_acab; 0: nenhum</translation>
        </message>
        <message>
            <source>The layer in the file</source>
            <translation>A camada no arquivo</translation>
        </message>
        <message>
            <source>The length of all cuts</source>
            <translation>O comprimento de todos os cortes</translation>
        </message>
        <message>
            <source>The length of all lines</source>
            <translation>O comprimento de todas as linhas</translation>
        </message>
        <message>
            <source>The length of the cutting edges; 0: not given</source>
            <translation>O comprimento das arestas de corte; 0: não informado</translation>
        </message>
        <message>
            <source>The length of the file's unit; 0: as the file says, or as its program usually means it</source>
            <translation>O comprimento da unidade do arquivo; 0: como o arquivo diz, ou como seu programa costuma querer dizer</translation>
        </message>
        <message>
            <source>The length of the lead's line</source>
            <translation>O comprimento da linha de entrada ou saída</translation>
        </message>
        <message>
            <source>The middle of a mill's end that does not cut; 0: it cuts over its centre</source>
            <translation>O meio do topo da fresa que não corta; 0: ela tem corte no centro</translation>
        </message>
        <message>
            <source>The middle of the circle, from the work zero</source>
            <translation>O meio do círculo, a partir do zero da peça</translation>
        </message>
        <message>
            <source>The minor diameter that is cut</source>
            <translation>O diâmetro menor que é cortado</translation>
        </message>
        <message>
            <source>The name in the file</source>
            <translation>O nome no arquivo</translation>
        </message>
        <message>
            <source>The nominal diameter; 0: that of each circle of the drawing</source>
            <translation>O diâmetro nominal; 0: o de cada círculo do desenho</translation>
        </message>
        <message>
            <source>The operations, in their order</source>
            <translation>O que é usinado, nesta ordem</translation>
        </message>
        <message>
            <source>The order in which the holes are made</source>
            <translation>A ordem em que os furos são feitos</translation>
        </message>
        <message>
            <source>The order in which the lines are cut</source>
            <translation>A ordem em que as linhas são cortadas</translation>
        </message>
        <message>
            <source>The other end of the diagonal, before the rectangle is rotated</source>
            <translation>A outra ponta da diagonal, antes de o retângulo ser girado</translation>
        </message>
        <message>
            <source>The outline seen from above, or the faces or the section at a height</source>
            <translation>O contorno visto de cima, ou as faces ou a seção a uma altura</translation>
        </message>
        <message>
            <source>The parts and bodies that the clamps move with</source>
            <translation>As peças e os corpos com que os grampos se movem</translation>
        </message>
        <message>
            <source>The parts and bodies that the drawings move with</source>
            <translation>As peças e corpos com os quais os desenhos se movem</translation>
        </message>
        <message>
            <source>The place of the work zero in this document</source>
            <translation>Onde fica o zero-peça neste documento</translation>
        </message>
        <message>
            <source>The place of the work zero on the stock</source>
            <translation>Onde fica o zero-peça no bloco</translation>
        </message>
        <message>
            <source>The places of the holes</source>
            <translation>Onde ficam os furos</translation>
        </message>
        <message>
            <source>The plunge feed of the program</source>
            <translation>O avanço de mergulho do programa</translation>
        </message>
        <message>
            <source>The points as they were drawn</source>
            <translation>Os pontos como foram desenhados</translation>
        </message>
        <message>
            <source>The program that is shown, checked and sent, if the machine needs one for each tool</source>
            <translation>Qual é mostrado, verificado e enviado, onde a máquina quer um por ferramenta</translation>
        </message>
        <message>
            <source>The program's dialect; empty: the machine's own</source>
            <translation>O dialeto do programa; vazio: o da própria máquina</translation>
        </message>
        <message>
            <source>The program, kept in this document</source>
            <translation>O programa, guardado neste documento</translation>
        </message>
        <message>
            <source>The radius of loops at sharp outside corners</source>
            <translation>O raio dos laços em cantos externos vivos</translation>
        </message>
        <message>
            <source>The radius of the lead's arc</source>
            <translation>O raio do arco de entrada ou saída</translation>
        </message>
        <message>
            <source>The share of the feed there</source>
            <translation>A parte do avanço ali</translation>
        </message>
        <message>
            <source>The share of the feed there; a slower wire melts a wider kerf</source>
            <translation>A parte do avanço ali; um fio mais lento derrete um corte mais largo</translation>
        </message>
        <message>
            <source>The share of the feed with which they are cut</source>
            <translation>A parte do avanço com que são cortados</translation>
        </message>
        <message>
            <source>The share of the power at the pierce</source>
            <translation>A parte da potência na perfuração</translation>
        </message>
        <message>
            <source>The sketch, wire, B-spline or freehand line to follow</source>
            <translation>O esboço, arame, B-spline ou linha à mão livre a seguir</translation>
        </message>
        <message>
            <source>The sketch, wires or faces to cut: closed lines are parts and holes in turn</source>
            <translation>O esboço, arames ou faces cujas linhas são cortadas: as fechadas são alternadamente peças e furos</translation>
        </message>
        <message>
            <source>The sketch, wires or faces to follow</source>
            <translation>O esboço, fios ou faces cujas linhas são seguidas</translation>
        </message>
        <message>
            <source>The speed of cutting moves; 0: that of the job's material</source>
            <translation>A velocidade dos movimentos de corte; 0: a do material do trabalho</translation>
        </message>
        <message>
            <source>The speed of the cut; 0: that of the chart</source>
            <translation>A velocidade do corte; 0: a da tabela</translation>
        </message>
        <message>
            <source>The speed straight down; 0: that of the job's material</source>
            <translation>A velocidade de descida reta; 0: a do material do trabalho</translation>
        </message>
        <message>
            <source>The spindle's speed in the program</source>
            <translation>A rotação do spindle no programa</translation>
        </message>
        <message>
            <source>The step of the published method</source>
            <translation>O passo do método publicado</translation>
        </message>
        <message>
            <source>The thickest chip that a tooth bears; 0: not given</source>
            <translation>O cavaco mais espesso que um dente suporta; 0: não informado</translation>
        </message>
        <message>
            <source>The thickest material left in inner corners</source>
            <translation>O material mais grosso que fica em cantos internos</translation>
        </message>
        <message>
            <source>The thickest material left in them</source>
            <translation>O material mais grosso que fica neles</translation>
        </message>
        <message>
            <source>The thinnest chip of a tooth, below which it rubs; 0: not given</source>
            <translation>O cavaco mais fino de um dente, abaixo do qual ele só atrita; 0: não informado</translation>
        </message>
        <message>
            <source>The tool that cuts it</source>
            <translation>A ferramenta que a executa</translation>
        </message>
        <message>
            <source>The tools that operations may choose from</source>
            <translation>As ferramentas que as operações podem escolher</translation>
        </message>
        <message>
            <source>The torch above the sheet while it cuts; 0: that of the chart</source>
            <translation>A tocha acima da chapa enquanto corta; 0: a altura da tabela</translation>
        </message>
        <message>
            <source>The torch above the sheet while it pierces; 0: that of the chart</source>
            <translation>A tocha acima da chapa enquanto perfura; 0: a altura da tabela</translation>
        </message>
        <message>
            <source>The width of one pass at most, ae</source>
            <translation>A largura máxima de um passe, ae</translation>
        </message>
        <message>
            <source>The width of the cut</source>
            <translation>A largura do corte</translation>
        </message>
        <message>
            <source>The width of the cut where it is not the chart's; 0: the chart's, else the tool's</source>
            <translation>A largura do corte quando não é a da tabela; 0: a da tabela, senão a da ferramenta</translation>
        </message>
        <message>
            <source>The width of the cut where it is not the tool's diameter; 0: the tool's own</source>
            <translation>A largura do corte onde não é o diâmetro da ferramenta; 0: a da própria ferramenta</translation>
        </message>
        <message>
            <source>The width of the cut; 0: that of the chart</source>
            <translation>A largura do corte; 0: a da tabela</translation>
        </message>
        <message>
            <source>The width of the cut; 0: that of the cut chart or the tool</source>
            <translation>A largura do corte; 0: a da tabela de corte ou da ferramenta</translation>
        </message>
        <message>
            <source>The width of the picture; 0: as its resolution says</source>
            <translation>A largura da imagem; 0: como sua resolução diz</translation>
        </message>
        <message>
            <source>The wire stays this close to every drawn point; 0 keeps every point that bends the line</source>
            <translation>O arame fica a no máximo esta distância de cada ponto desenhado; 0 mantém todos os pontos que curvam a linha</translation>
        </message>
        <message>
            <source>The work coordinate system</source>
            <translation>O sistema de coordenadas da peça</translation>
        </message>
        <message>
            <source>Threshold</source>
            <translation>Limiar</translation>
        </message>
        <message>
            <source>Through</source>
            <translation>Além</translation>
        </message>
        <message>
            <source>Time of the tool at rest with power; 0: from the cut chart</source>
            <translation>Quanto tempo a ferramenta fica parada com potência; 0: o da tabela de corte</translation>
        </message>
        <message>
            <source>Tiny</source>
            <translation>Minúscula</translation>
        </message>
        <message>
            <source>Tip</source>
            <translation>Ponta</translation>
        </message>
        <message>
            <source>Tip Angle</source>
            <translation>Ângulo da ponta</translation>
        </message>
        <message>
            <source>Tip Diameter</source>
            <translation>Diâmetro da ponta</translation>
        </message>
        <message>
            <source>Tip angle</source>
            <translation>Ângulo da ponta</translation>
        </message>
        <message>
            <source>Tip diameter</source>
            <translation>Diâmetro da ponta</translation>
        </message>
        <message>
            <source>To</source>
            <translation>Até</translation>
        </message>
        <message>
            <source>Tolerance</source>
            <translation>Tolerância</translation>
        </message>
        <message>
            <source>Tolerance of the cut line, which reduces the number of moves; 0: none</source>
            <translation>Quanto a linha cortada pode se afastar da desenhada para ter menos movimentos; 0: nada</translation>
        </message>
        <message>
            <source>Tool</source>
            <translation>Ferramenta</translation>
        </message>
        <message>
            <source>Tool Shape</source>
            <translation>Forma da ferramenta</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Ferramentas</translation>
        </message>
        <message>
            <source>Tools without feeds or speed use its table</source>
            <translation>Ferramentas sem avanço ou rotação tomam os da sua tabela</translation>
        </message>
        <message>
            <source>Torch off before</source>
            <translation>Desliga antes</translation>
        </message>
        <message>
            <source>Trace Tolerance</source>
            <translation>Tolerância do traçado</translation>
        </message>
        <message>
            <source>Trace what is light instead of what is dark</source>
            <translation>Traça o que é claro em vez do que é escuro</translation>
        </message>
        <message>
            <source>Turns</source>
            <translation>Voltas</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Unidade</translation>
        </message>
        <message>
            <source>Units</source>
            <translation>Unidades</translation>
        </message>
        <message>
            <source>Unreachable</source>
            <translation>Inalcançável</translation>
        </message>
        <message>
            <source>Wall feed</source>
            <translation>Avanço na parede</translation>
        </message>
        <message>
            <source>What becomes one object</source>
            <translation>O que vira um objeto</translation>
        </message>
        <message>
            <source>What is written; several lines are set below each other</source>
            <translation>O que se escreve; várias linhas ficam uma abaixo da outra</translation>
        </message>
        <message>
            <source>What the height is measured of</source>
            <translation>De que se mede a altura</translation>
        </message>
        <message>
            <source>What the letters stand on</source>
            <translation>Sobre o que as letras ficam</translation>
        </message>
        <message>
            <source>What was found in it</source>
            <translation>O que foi achado nele</translation>
        </message>
        <message>
            <source>What was read</source>
            <translation>O que foi lido</translation>
        </message>
        <message>
            <source>Where rapids travel across the work</source>
            <translation>Altura dos movimentos rápidos sobre a peça</translation>
        </message>
        <message>
            <source>Where the arc begins; counter-clockwise from X</source>
            <translation>Onde o arco começa; anti-horário a partir de X</translation>
        </message>
        <message>
            <source>Where the line begins</source>
            <translation>Onde a linha começa</translation>
        </message>
        <message>
            <source>Where the line ends</source>
            <translation>Onde a linha termina</translation>
        </message>
        <message>
            <source>Where the row begins, from the work zero</source>
            <translation>Onde a fileira começa, a partir do zero da peça</translation>
        </message>
        <message>
            <source>Where the row ends</source>
            <translation>Onde a fileira termina</translation>
        </message>
        <message>
            <source>Where the text stands about its zero, or on its line</source>
            <translation>Onde o texto fica em torno de seu zero, ou em sua linha</translation>
        </message>
        <message>
            <source>Whether a laser's power follows its speed (M4)</source>
            <translation>Se a potência do laser acompanha a velocidade (M4)</translation>
        </message>
        <message>
            <source>Whether a slit through the part leads the wire into a closed hole</source>
            <translation>Se uma fenda através da peça leva o fio a um furo fechado</translation>
        </message>
        <message>
            <source>Whether all of its chains are closed</source>
            <translation>Se todos os seus contornos são fechados</translation>
        </message>
        <message>
            <source>Whether form, kerf and feeds are those of the job's cut chart</source>
            <translation>Se forma, largura do corte e avanços são os da tabela de corte do trabalho</translation>
        </message>
        <message>
            <source>Whether inner corners are opened, so that a square corner fits in</source>
            <translation>Se os cantos internos são abertos para que um canto vivo caiba</translation>
        </message>
        <message>
            <source>Whether the depth is that of the point or of the full diameter</source>
            <translation>Se a profundidade é a da ponta ou a do diâmetro pleno</translation>
        </message>
        <message>
            <source>Whether the file fills it</source>
            <translation>Se o arquivo o preenche</translation>
        </message>
        <message>
            <source>Whether the file is as it was read</source>
            <translation>Se o arquivo está como foi lido</translation>
        </message>
        <message>
            <source>Whether the last point joins the first</source>
            <translation>Se o último ponto se une ao primeiro</translation>
        </message>
        <message>
            <source>Whether the program holds it</source>
            <translation>Se o programa a contém</translation>
        </message>
        <message>
            <source>Why it cannot be made; empty when it can</source>
            <translation>Por que não pode ser feito; vazio quando pode</translation>
        </message>
        <message>
            <source>Why there is no program</source>
            <translation>Por que não há programa</translation>
        </message>
        <message>
            <source>Width</source>
            <translation>Largura</translation>
        </message>
        <message>
            <source>Work Offset</source>
            <translation>Sistema de coordenadas</translation>
        </message>
        <message>
            <source>Work Origin</source>
            <translation>Zero-peça</translation>
        </message>
        <message>
            <source>Work offset</source>
            <translation>Sistema de coordenadas</translation>
        </message>
        <message>
            <source>Work zero</source>
            <translation>Zero-peça</translation>
        </message>
        <message>
            <source>Z of the faces or of the section</source>
            <translation>Z das faces ou da seção</translation>
        </message>
        <message>
            <source>Zero's place</source>
            <translation>Lugar do zero</translation>
        </message>
        <message>
            <source>ae, recalculated to whole passes</source>
            <translation>ae, recalculada para passes inteiros</translation>
        </message>
        <message>
            <source>ap, recalculated to whole passes</source>
            <translation>ap, recalculada para passes inteiros</translation>
        </message>
        <message>
            <source>by numbers</source>
            <translation>por números</translation>
        </message>
        <message>
            <source>none yet</source>
            <translation>nenhum ainda</translation>
        </message>
        <message>
            <source>the whole stock</source>
            <translation>o bloco todo</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper</name>
        <message>
            <source>'{0}' has no meaning in a number</source>
            <translation>'{0}' não faz sentido em um número</translation>
        </message>
        <message>
            <source>'{0}' has several decimal separators; write 1234.5 or 1234,5</source>
            <translation>'{0}' tem vários separadores decimais; escreva 1234,5 ou 1234.5</translation>
        </message>
        <message>
            <source>'{0}' is no number</source>
            <translation>'{0}' não é um número</translation>
        </message>
        <message>
            <source>'{0}' is no place; write X; Y</source>
            <translation>'{0}' não é um lugar; escreva X; Y</translation>
        </message>
        <message>
            <source>'{0}' is no value in {1}</source>
            <translation>'{0}' não é um valor em {1}</translation>
        </message>
        <message>
            <source>'{0}' is no whole number</source>
            <translation>'{0}' não é um número inteiro</translation>
        </message>
        <message>
            <source>'{0}' is not in the program</source>
            <translation>'{0}' não aparece no programa</translation>
        </message>
        <message>
            <source>'{0}' is too large</source>
            <translation>'{0}' é grande demais</translation>
        </message>
        <message>
            <source>45° blade</source>
            <translation>lâmina de 45°</translation>
        </message>
        <message>
            <source>60° blade</source>
            <translation>lâmina de 60°</translation>
        </message>
        <message>
            <source>A TrueType or OpenType file, instead of the font</source>
            <translation>Um arquivo TrueType ou OpenType, em vez da fonte</translation>
        </message>
        <message>
            <source>A bar above and a stem below, the zero in the middle of the bar's upper edge; three holes.</source>
            <translation>Uma barra em cima e uma haste embaixo, o zero no meio da borda superior da barra; três furos.</translation>
        </message>
        <message>
            <source>A bore about the zero with a keyway above (DIN 6885: bore and key's depth over all).</source>
            <translation>Um furo em torno do zero com rasgo de chaveta em cima (DIN 6885: furo e profundidade total da chaveta).</translation>
        </message>
        <message>
            <source>A chart's file…</source>
            <translation>Um arquivo de tabela…</translation>
        </message>
        <message>
            <source>A circle about the zero.</source>
            <translation>Um círculo em torno do zero.</translation>
        </message>
        <message>
            <source>A controller is connected already.</source>
            <translation>Um controlador já está conectado.</translation>
        </message>
        <message>
            <source>A cross of two bars about the zero.</source>
            <translation>Uma cruz de duas barras em torno do zero.</translation>
        </message>
        <message>
            <source>A cut chart</source>
            <translation>Uma tabela de corte</translation>
        </message>
        <message>
            <source>A deleted drawing is checked: uncheck it to go on without it</source>
            <translation>Um desenho apagado está marcado: desmarque-o para continuar sem ele</translation>
        </message>
        <message>
            <source>A disc about the zero less another one beside it, like a moon.</source>
            <translation>Um disco em torno do zero menos outro ao lado, como uma lua.</translation>
        </message>
        <message>
            <source>A disc about the zero with round notches in its rim and a bore.</source>
            <translation>Um disco em torno do zero com entalhes redondos na borda e um furo.</translation>
        </message>
        <message>
            <source>A disc about the zero, cut off straight above.</source>
            <translation>Um disco em torno do zero, cortado reto em cima.</translation>
        </message>
        <message>
            <source>A drop: a disc about the zero and a point above.</source>
            <translation>Uma gota: um disco em torno do zero e uma ponta em cima.</translation>
        </message>
        <message>
            <source>A factor of the font's own</source>
            <translation>Um fator da entrelinha da própria fonte</translation>
        </message>
        <message>
            <source>A file is checked with a job's machine, stock, tools and clamps; no operation is needed.</source>
            <translation>Um arquivo é verificado com a máquina, o bloco, as ferramentas e os grampos de um trabalho; nenhuma operação é necessária.</translation>
        </message>
        <message>
            <source>A flange of two bolts along X: a disc about the zero with an ear on each side.</source>
            <translation>Um flange de dois parafusos ao longo de X: um disco em torno do zero com uma orelha de cada lado.</translation>
        </message>
        <message>
            <source>A font of the system, or a single-line font for engraving</source>
            <translation>Uma fonte do sistema, ou uma fonte de linha única para gravar</translation>
        </message>
        <message>
            <source>A heart of two half circles over a rounded tip, the zero in its notch.</source>
            <translation>Um coração de dois semicírculos sobre uma ponta, o zero no entalhe.</translation>
        </message>
        <message>
            <source>A hole to hang a part on a screw: a circle about the zero for its head, a slot above for its shank.</source>
            <translation>Um furo para pendurar a peça em um parafuso: um círculo em torno do zero para a cabeça, um rasgo em cima para o corpo.</translation>
        </message>
        <message>
            <source>A hook to hang things on: a plate with two holes above, the hook's round inside about the zero.</source>
            <translation>Um gancho para pendurar coisas: uma chapa com dois furos em cima, o interior do gancho em torno do zero.</translation>
        </message>
        <message>
            <source>A job is being cut</source>
            <translation>Um trabalho está sendo usinado</translation>
        </message>
        <message>
            <source>A job is being cut already: wait for its end, or stop it.</source>
            <translation>Um trabalho já está sendo usinado: espere o fim ou pare-o.</translation>
        </message>
        <message>
            <source>A job is being cut: stop it first.</source>
            <translation>Um trabalho está sendo usinado: pare-o antes.</translation>
        </message>
        <message>
            <source>A job is being cut: wait for its end, or stop it.</source>
            <translation>Um trabalho está sendo cortado: espere o fim ou pare-o.</translation>
        </message>
        <message>
            <source>A label about the zero: round corners, cut off on the left, with a hole for a string.</source>
            <translation>Uma etiqueta em torno do zero: cantos redondos, cortada à esquerda, com um furo para o cordão.</translation>
        </message>
        <message>
            <source>A laser's S word for marks; 0: a twentieth of its power</source>
            <translation>A palavra S do laser para marcas; 0: um vigésimo da potência</translation>
        </message>
        <message>
            <source>A laser's power that rises behind the pierce</source>
            <translation>Potência do laser que sobe depois da perfuração</translation>
        </message>
        <message>
            <source>A line for the controller, sent with Return. The arrow keys bring back the lines before.</source>
            <translation>Uma linha para o controlador, enviada com Enter. As setas trazem de volta as linhas anteriores.</translation>
        </message>
        <message>
            <source>A line of the program that was cut already.</source>
            <translation>Uma linha do programa que já foi cortada.</translation>
        </message>
        <message>
            <source>A lower feed at corners</source>
            <translation>Avanço menor nos cantos</translation>
        </message>
        <message>
            <source>A lower feed on arcs of a small radius</source>
            <translation>Avanço menor em arcos de raio pequeno</translation>
        </message>
        <message>
            <source>A machine's profile</source>
            <translation>Perfil de uma máquina</translation>
        </message>
        <message>
            <source>A parallelogram, its left lower corner at the zero.</source>
            <translation>Um paralelogramo, o canto inferior esquerdo no zero.</translation>
        </message>
        <message>
            <source>A piece of a ring about the zero, from X counter-clockwise.</source>
            <translation>Um pedaço de anel em torno do zero, a partir de X no sentido anti-horário.</translation>
        </message>
        <message>
            <source>A plate about the zero for a stepper motor of NEMA size 8, 11, 14, 17, 23 or 34.</source>
            <translation>Uma chapa em torno do zero para um motor de passo de tamanho NEMA 8, 11, 14, 17, 23 ou 34.</translation>
        </message>
        <message>
            <source>A plate about the zero with an eye and a hole at each of three corners.</source>
            <translation>Uma chapa em torno do zero com um olhal e um furo em cada um de três cantos.</translation>
        </message>
        <message>
            <source>A plate to hang a load: a base below, an eye about the zero above.</source>
            <translation>Uma chapa para pendurar uma carga: uma base embaixo, um olhal em torno do zero em cima.</translation>
        </message>
        <message>
            <source>A polygon of equal sides about the zero, one side below; the size is across the flats.</source>
            <translation>Um polígono de lados iguais em torno do zero, um lado embaixo; o tamanho é entre faces.</translation>
        </message>
        <message>
            <source>A profile's file…</source>
            <translation>Arquivo de perfil…</translation>
        </message>
        <message>
            <source>A program without F runs at {0} mm/min ({1}; kerf {2} mm).</source>
            <translation>Um programa sem F usa {0} mm/min ({1}; largura de corte {2} mm).</translation>
        </message>
        <message>
            <source>A rectangle about the zero with its corners cut off at 45°.</source>
            <translation>Um retângulo em torno do zero com os cantos cortados a 45°.</translation>
        </message>
        <message>
            <source>A rectangle about the zero, its corners sharp or round.</source>
            <translation>Um retângulo em torno do zero, de cantos vivos ou redondos.</translation>
        </message>
        <message>
            <source>A rectangular plate about the zero with a hole near each corner.</source>
            <translation>Uma chapa retangular em torno do zero com um furo perto de cada canto.</translation>
        </message>
        <message>
            <source>A right-angled stiffening plate, its right angle at the zero, cut off there to clear a weld.</source>
            <translation>Uma chapa de reforço em ângulo reto, o ângulo reto no zero, cortada ali para dar lugar à solda.</translation>
        </message>
        <message>
            <source>A ring, or a washer, about the zero.</source>
            <translation>Um anel, ou uma arruela, em torno do zero.</translation>
        </message>
        <message>
            <source>A round flange about the zero with a bore and a circle of bolt holes.</source>
            <translation>Um flange redondo em torno do zero com um furo central e um círculo de furos de parafusos.</translation>
        </message>
        <message>
            <source>A round hole with flat sides above and below, about the zero.</source>
            <translation>Um furo redondo com faces planas em cima e embaixo, em torno do zero.</translation>
        </message>
        <message>
            <source>A round hole with one flat side above, for shafts with a flat; about the circle's middle.</source>
            <translation>Um furo redondo com uma face plana em cima, para eixos com face plana; em torno do centro do círculo.</translation>
        </message>
        <message>
            <source>A serial port, or an address as socket://192.168.0.7:23</source>
            <translation>Uma porta serial, ou um endereço como socket://192.168.0.7:23</translation>
        </message>
        <message>
            <source>A share of the machine's greatest power; 0: that of the chart</source>
            <translation>Uma parte da potência máxima da máquina; 0: a da tabela</translation>
        </message>
        <message>
            <source>A shield, the zero in the middle of its upper edge: straight sides, round below.</source>
            <translation>Um escudo, o zero no meio da borda superior: lados retos, redondo embaixo.</translation>
        </message>
        <message>
            <source>A shipped profile's name, or a profile's file</source>
            <translation>O nome de um perfil fornecido, ou o arquivo de um perfil</translation>
        </message>
        <message>
            <source>A short sound at an alarm, an end, a pause, and for a part beyond the work surface</source>
            <translation>Um som curto em alarme, fim, pausa e para uma peça que excede a superfície de trabalho</translation>
        </message>
        <message>
            <source>A sketch or wire that holds one circle; without it the numbers count</source>
            <translation>Um esboço ou fio que contenha um círculo; sem ele valem os números</translation>
        </message>
        <message>
            <source>A sketch or wire that holds one ellipse; without it the numbers count</source>
            <translation>Um esboço ou arame com uma elipse; sem ele valem os números</translation>
        </message>
        <message>
            <source>A sketch or wire that holds one rectangle; without it the numbers count</source>
            <translation>Um esboço ou fio que contenha um retângulo; sem ele valem os números</translation>
        </message>
        <message>
            <source>A sketch, wires or faces: closed lines, those inside are islands</source>
            <translation>Um esboço, fios ou faces: linhas fechadas, as de dentro são ilhas</translation>
        </message>
        <message>
            <source>A slice of a disc about the zero, from X counter-clockwise.</source>
            <translation>Uma fatia de disco em torno do zero, a partir de X no sentido anti-horário.</translation>
        </message>
        <message>
            <source>A slot in the edge of a plate for a bolt's head: open below, the zero at its mouth's middle.</source>
            <translation>Um rasgo na borda de uma chapa para a cabeça de um parafuso: aberto embaixo, o zero no meio da boca.</translation>
        </message>
        <message>
            <source>A slot with round ends along an arc about the zero, from X counter-clockwise.</source>
            <translation>Um rasgo de pontas redondas ao longo de um arco em torno do zero, a partir de X no sentido anti-horário.</translation>
        </message>
        <message>
            <source>A square plate about the zero with a bore and a hole near each corner.</source>
            <translation>Uma chapa quadrada em torno do zero com um furo central e um furo perto de cada canto.</translation>
        </message>
        <message>
            <source>A star about the zero, one point above.</source>
            <translation>Uma estrela em torno do zero, uma ponta em cima.</translation>
        </message>
        <message>
            <source>A straight slot with round ends along X, about the zero; the length is over all.</source>
            <translation>Um rasgo reto de pontas redondas ao longo de X, em torno do zero; o comprimento é o total.</translation>
        </message>
        <message>
            <source>A tool of this shape has none</source>
            <translation>Uma ferramenta desta forma não tem este valor</translation>
        </message>
        <message>
            <source>A trapezoid, the zero in the middle of its base.</source>
            <translation>Um trapézio, o zero no meio da base.</translation>
        </message>
        <message>
            <source>A triangle with two equal sides, the zero in the middle of its base.</source>
            <translation>Um triângulo de dois lados iguais, o zero no meio da base.</translation>
        </message>
        <message>
            <source>A turn, as they are counted</source>
            <translation>Por volta, como são contados</translation>
        </message>
        <message>
            <source>A value is missing here</source>
            <translation>Falta um valor aqui</translation>
        </message>
        <message>
            <source>A wheel about the zero with saw teeth and a bore.</source>
            <translation>Uma roda em torno do zero com dentes de serra e um furo.</translation>
        </message>
        <message>
            <source>About the first corner, counter-clockwise</source>
            <translation>Em torno do primeiro canto, no sentido anti-horário</translation>
        </message>
        <message>
            <source>Above</source>
            <translation>Acima</translation>
        </message>
        <message>
            <source>Acceleration</source>
            <translation>Aceleração</translation>
        </message>
        <message>
            <source>Acceleration in steps</source>
            <translation>Aceleração em passos</translation>
        </message>
        <message>
            <source>Across the flat</source>
            <translation>Até a face plana</translation>
        </message>
        <message>
            <source>Across the flats</source>
            <translation>Entre faces planas</translation>
        </message>
        <message>
            <source>Active</source>
            <translation>Ativa</translation>
        </message>
        <message>
            <source>Add</source>
            <translation>Adicionar</translation>
        </message>
        <message>
            <source>Add a tool to this job</source>
            <translation>Adiciona uma ferramenta a este trabalho</translation>
        </message>
        <message>
            <source>Add selected</source>
            <translation>Usar seleção</translation>
        </message>
        <message>
            <source>Add selection</source>
            <translation>Incluir seleção</translation>
        </message>
        <message>
            <source>Add the part in its present state to the document as a mesh</source>
            <translation>Acrescentar ao documento, como malha, a peça tal como está agora</translation>
        </message>
        <message>
            <source>Add the tools of FreeCAD's library or of a tool table</source>
            <translation>Adiciona as ferramentas da biblioteca do FreeCAD ou de uma tabela de ferramentas</translation>
        </message>
        <message>
            <source>Add tool</source>
            <translation>Adicionar</translation>
        </message>
        <message>
            <source>Added between letters</source>
            <translation>Acrescentado entre as letras</translation>
        </message>
        <message>
            <source>After {0}</source>
            <translation>Depois de {0}</translation>
        </message>
        <message>
            <source>Alarm</source>
            <translation>Alarme</translation>
        </message>
        <message>
            <source>Alignment</source>
            <translation>Alinhamento</translation>
        </message>
        <message>
            <source>All</source>
            <translation>Todos</translation>
        </message>
        <message>
            <source>All = 0</source>
            <translation>Todos = 0</translation>
        </message>
        <message>
            <source>All files ({0})</source>
            <translation>Todos os arquivos ({0})</translation>
        </message>
        <message>
            <source>All lines are sent; the last moves are being cut.</source>
            <translation>Todas as linhas foram enviadas; os últimos movimentos estão sendo usinados.</translation>
        </message>
        <message>
            <source>All, the outline, or the holes in it</source>
            <translation>Todas, o contorno, ou os furos nele</translation>
        </message>
        <message>
            <source>All, the outlines of letters, or the holes in them</source>
            <translation>Todas, os contornos das letras, ou os furos nelas</translation>
        </message>
        <message>
            <source>Allow jogging: spindle or beam off; Resume returns to the cut on a safe path.</source>
            <translation>Permite mover a máquina manualmente: spindle ou feixe desligado; Retomar volta ao corte por um caminho seguro.</translation>
        </message>
        <message>
            <source>Along</source>
            <translation>Ao longo de</translation>
        </message>
        <message>
            <source>Along X, mm</source>
            <translation>Ao longo de X, mm</translation>
        </message>
        <message>
            <source>Along Y, mm</source>
            <translation>Ao longo de Y, mm</translation>
        </message>
        <message>
            <source>Along Z, mm</source>
            <translation>Ao longo de Z, mm</translation>
        </message>
        <message>
            <source>Along a line or arc</source>
            <translation>Ao longo de uma linha ou arco</translation>
        </message>
        <message>
            <source>Also follow the selected lines</source>
            <translation>Seguir também o que está selecionado</translation>
        </message>
        <message>
            <source>An angle of two legs, its outer corner at the zero, a hole near the end of each leg.</source>
            <translation>Uma cantoneira de duas abas, o canto externo no zero, um furo perto da ponta de cada aba.</translation>
        </message>
        <message>
            <source>An arrow along X, its tip at the zero.</source>
            <translation>Uma seta ao longo de X, a ponta no zero.</translation>
        </message>
        <message>
            <source>An expression gives this value; change it in the property editor</source>
            <translation>Uma expressão define este valor; altere-o no editor de propriedades</translation>
        </message>
        <message>
            <source>Angle</source>
            <translation>Ângulo</translation>
        </message>
        <message>
            <source>Angle in</source>
            <translation>Ângulo entrada</translation>
        </message>
        <message>
            <source>Angle out</source>
            <translation>Ângulo saída</translation>
        </message>
        <message>
            <source>Another machine?</source>
            <translation>Outra máquina?</translation>
        </message>
        <message>
            <source>Apply</source>
            <translation>Aplicar</translation>
        </message>
        <message>
            <source>Arc slot</source>
            <translation>Rasgo em arco</translation>
        </message>
        <message>
            <source>Arc tolerance</source>
            <translation>Tolerância de arco</translation>
        </message>
        <message>
            <source>Arcs and lines this close to the drawn points, instead of the tolerance; 0: straight lines</source>
            <translation>Arcos e linhas a esta distância dos pontos desenhados, em vez da tolerância; 0: linhas retas</translation>
        </message>
        <message>
            <source>Arcs below</source>
            <translation>Arcos abaixo de</translation>
        </message>
        <message>
            <source>Arcs of a smaller radius are cut slowly; 0: none</source>
            <translation>Arcos de raio menor são cortados devagar; 0: nenhum</translation>
        </message>
        <message>
            <source>Arcs within a tolerance, or the published points</source>
            <translation>Arcos dentro de uma tolerância, ou os pontos publicados</translation>
        </message>
        <message>
            <source>Arrow</source>
            <translation>Seta</translation>
        </message>
        <message>
            <source>As a multiple of the thickness; 0: none by thickness</source>
            <translation>Como múltiplo da espessura; 0: nenhum pela espessura</translation>
        </message>
        <message>
            <source>As many as can be made at most, in Hz</source>
            <translation>Quantos podem ser gerados no máximo, em Hz</translation>
        </message>
        <message>
            <source>As people call the machine</source>
            <translation>Como as pessoas chamam a máquina</translation>
        </message>
        <message>
            <source>At smaller corners the wire neither pauses nor slows down</source>
            <translation>Onde o caminho vira menos, o fio nem para nem vai mais devagar</translation>
        </message>
        <message>
            <source>At the end of {0}</source>
            <translation>No fim de {0}</translation>
        </message>
        <message>
            <source>Attached again to the controller at {0}.</source>
            <translation>Reconectado ao controlador em {0}.</translation>
        </message>
        <message>
            <source>Axes</source>
            <translation>Eixos</translation>
        </message>
        <message>
            <source>Axis</source>
            <translation>Eixo</translation>
        </message>
        <message>
            <source>Axis arithmetic</source>
            <translation>Cálculo do eixo</translation>
        </message>
        <message>
            <source>Axis whose sign changes</source>
            <translation>Eixo cujo sinal muda</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>Voltar</translation>
        </message>
        <message>
            <source>Back along the cut</source>
            <translation>De volta ao longo do corte</translation>
        </message>
        <message>
            <source>Back from here to the begin</source>
            <translation>Voltar daqui ao início</translation>
        </message>
        <message>
            <source>Backlash</source>
            <translation>Folga</translation>
        </message>
        <message>
            <source>Backlash of the axis in the profile; the moves sent compensate it</source>
            <translation>O que o eixo perde em uma inversão, como diz o perfil; os movimentos enviados compensam</translation>
        </message>
        <message>
            <source>Base</source>
            <translation>Base</translation>
        </message>
        <message>
            <source>Before {0}</source>
            <translation>Antes de {0}</translation>
        </message>
        <message>
            <source>Begin so much earlier on the same cut, so that no ridge stays</source>
            <translation>Começa tanto antes no mesmo corte, para que não fique nenhuma rebarba</translation>
        </message>
        <message>
            <source>Begins at</source>
            <translation>Começa em</translation>
        </message>
        <message>
            <source>Being sent, {0} left</source>
            <translation>Enviando, faltam {0}</translation>
        </message>
        <message>
            <source>Below thickness times</source>
            <translation>Abaixo de × espessura</translation>
        </message>
        <message>
            <source>Below this grey, 1 to 255, it is dark; 0: found from the picture</source>
            <translation>Abaixo deste cinza, 1 a 255, é escuro; 0: achado na imagem</translation>
        </message>
        <message>
            <source>Belt's pitch</source>
            <translation>Passo da correia</translation>
        </message>
        <message>
            <source>Between neighbouring helices at most; 0: 0.4 of the tool's diameter</source>
            <translation>Entre hélices vizinhas no máximo; 0: 0,4 do diâmetro da ferramenta</translation>
        </message>
        <message>
            <source>Between the two sides of a V-bit or engraver; 0: not given</source>
            <translation>Entre os dois lados de uma fresa em V ou de gravação; 0: não informado</translation>
        </message>
        <message>
            <source>Between the two sides of a drill's point; 0: not given</source>
            <translation>Entre os dois lados da ponta de uma broca; 0: não informado</translation>
        </message>
        <message>
            <source>Beyond</source>
            <translation>Além</translation>
        </message>
        <message>
            <source>Blade offset</source>
            <translation>Recuo da lâmina</translation>
        </message>
        <message>
            <source>Blur</source>
            <translation>Desfoque</translation>
        </message>
        <message>
            <source>Bore</source>
            <translation>Mandrilar</translation>
        </message>
        <message>
            <source>Bore; 0: none</source>
            <translation>Furo central; 0: nenhum</translation>
        </message>
        <message>
            <source>Boring</source>
            <translation>Mandrilamento</translation>
        </message>
        <message>
            <source>Brackets</source>
            <translation>Suportes</translation>
        </message>
        <message>
            <source>Bridges that hold the part until it is broken out</source>
            <translation>Pontes que seguram a peça até ela ser destacada</translation>
        </message>
        <message>
            <source>Busy</source>
            <translation>Ocupado</translation>
        </message>
        <message>
            <source>By colour</source>
            <translation>Por cor</translation>
        </message>
        <message>
            <source>By which share the lathe may be slower than its published step times</source>
            <translation>Que fração o torno pode ser mais lento que seus tempos de passo publicados</translation>
        </message>
        <message>
            <source>Bytes ahead at most</source>
            <translation>Bytes à frente no máximo</translation>
        </message>
        <message>
            <source>CNCStepper has a fault: {0}</source>
            <translation>O CNCStepper tem uma falha: {0}</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancelar</translation>
        </message>
        <message>
            <source>Centre</source>
            <translation>Centro</translation>
        </message>
        <message>
            <source>Certain</source>
            <translation>Certo</translation>
        </message>
        <message>
            <source>Chamfer along each side</source>
            <translation>Chanfro ao longo de cada lado</translation>
        </message>
        <message>
            <source>Chamfered rectangle</source>
            <translation>Retângulo chanfrado</translation>
        </message>
        <message>
            <source>Change</source>
            <translation>Alterar</translation>
        </message>
        <message>
            <source>Change of wait</source>
            <translation>Mudança da espera</translation>
        </message>
        <message>
            <source>Change the programmed value while cutting, in percent.</source>
            <translation>Ajusta o valor programado durante o corte, em porcento.</translation>
        </message>
        <message>
            <source>Changes of the job's own program since then</source>
            <translation>O que aconteceu desde então com o programa do próprio trabalho</translation>
        </message>
        <message>
            <source>Chart</source>
            <translation>Tabela</translation>
        </message>
        <message>
            <source>Check a G-code file with the job's machine, stock, tools and clamps, and send it.</source>
            <translation>Verificar um arquivo de G-code com a máquina, o bloco, as ferramentas e os grampos do trabalho, e enviá-lo.</translation>
        </message>
        <message>
            <source>Check and send</source>
            <translation>Verificar e enviar</translation>
        </message>
        <message>
            <source>Check and simulate: {0}</source>
            <translation>Verificar e simular: {0}</translation>
        </message>
        <message>
            <source>Checking against the machine…</source>
            <translation>Comparando com a máquina…</translation>
        </message>
        <message>
            <source>Checking the program</source>
            <translation>Verificando o programa</translation>
        </message>
        <message>
            <source>Choose a line, an entry of the list, or click a cut in the 3D view. Everything before it counts as cut; if unsure, choose an earlier one.</source>
            <translation>Escolha uma linha, uma entrada da lista ou clique em um corte na vista 3D. Tudo antes conta como cortado: na dúvida, escolha um lugar anterior.</translation>
        </message>
        <message>
            <source>Choose a material: the chart then gives feed and kerf</source>
            <translation>Escolha um material: a tabela dá então o avanço e a largura do corte</translation>
        </message>
        <message>
            <source>Choose a port, or type an address.</source>
            <translation>Escolha uma porta ou digite um endereço.</translation>
        </message>
        <message>
            <source>Choose a port, then connect.</source>
            <translation>Escolha uma porta e conecte.</translation>
        </message>
        <message>
            <source>Choose above where to cut, then connect.</source>
            <translation>Escolha acima onde usinar e conecte.</translation>
        </message>
        <message>
            <source>Choose another file</source>
            <translation>Escolher outro arquivo</translation>
        </message>
        <message>
            <source>Choose one here</source>
            <translation>Escolha aqui</translation>
        </message>
        <message>
            <source>Circle</source>
            <translation>Círculo</translation>
        </message>
        <message>
            <source>Circular pocket</source>
            <translation>Bolsão circular</translation>
        </message>
        <message>
            <source>Clamps</source>
            <translation>Grampos</translation>
        </message>
        <message>
            <source>Clearance</source>
            <translation>Altura de segurança</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Fechar</translation>
        </message>
        <message>
            <source>Close gaps</source>
            <translation>Fechar vãos</translation>
        </message>
        <message>
            <source>Close the open task panel first</source>
            <translation>Feche antes o painel de tarefas aberto</translation>
        </message>
        <message>
            <source>Close the safety door, then resume.</source>
            <translation>Feche a porta de segurança e retome.</translation>
        </message>
        <message>
            <source>Closed</source>
            <translation>Fechada</translation>
        </message>
        <message>
            <source>Closed lines around the area to face; without them the whole stock</source>
            <translation>Linhas fechadas em volta do que é faceado; sem elas, o bloco inteiro</translation>
        </message>
        <message>
            <source>Columns</source>
            <translation>Colunas</translation>
        </message>
        <message>
            <source>Come from above</source>
            <translation>Vir de cima</translation>
        </message>
        <message>
            <source>Come from below</source>
            <translation>Vir de baixo</translation>
        </message>
        <message>
            <source>Commanded length</source>
            <translation>Comprimento comandado</translation>
        </message>
        <message>
            <source>Comparing the cut with the drawing…</source>
            <translation>Comparando o corte com o desenho…</translation>
        </message>
        <message>
            <source>Connect</source>
            <translation>Conectar</translation>
        </message>
        <message>
            <source>Connect to a controller first.</source>
            <translation>Conecte-se antes a um controlador.</translation>
        </message>
        <message>
            <source>Connect to the controller at this port.</source>
            <translation>Conecta ao controlador nesta porta.</translation>
        </message>
        <message>
            <source>Connect to the machine first, in the controller's panel.</source>
            <translation>Conecte primeiro à máquina, no painel do controlador.</translation>
        </message>
        <message>
            <source>Connected and idle. Take the tool out, or lift it.</source>
            <translation>Conectada e parada. Retire a ferramenta ou levante-a.</translation>
        </message>
        <message>
            <source>Connecting…</source>
            <translation>Conectando…</translation>
        </message>
        <message>
            <source>Connection lost</source>
            <translation>Conexão perdida</translation>
        </message>
        <message>
            <source>Console</source>
            <translation>Console</translation>
        </message>
        <message>
            <source>Consumable</source>
            <translation>Consumível</translation>
        </message>
        <message>
            <source>Containers</source>
            <translation>Recipientes</translation>
        </message>
        <message>
            <source>Containers of the clamps</source>
            <translation>Recipientes dos grampos</translation>
        </message>
        <message>
            <source>Contour</source>
            <translation>Contorno</translation>
        </message>
        <message>
            <source>Contour that crosses itself</source>
            <translation>Contorno que cruza a si mesmo</translation>
        </message>
        <message>
            <source>Contour {0}</source>
            <translation>Contorno {0}</translation>
        </message>
        <message>
            <source>Contours</source>
            <translation>Contornos</translation>
        </message>
        <message>
            <source>Contours that cross</source>
            <translation>Contornos que se cruzam</translation>
        </message>
        <message>
            <source>Controller</source>
            <translation>Controlador</translation>
        </message>
        <message>
            <source>Controller's buffer: {0} blocks and {1} bytes free</source>
            <translation>Memória do controlador: {0} blocos e {1} bytes livres</translation>
        </message>
        <message>
            <source>Convert for this machine…</source>
            <translation>Converter para esta máquina…</translation>
        </message>
        <message>
            <source>Convert units…</source>
            <translation>Converter unidades…</translation>
        </message>
        <message>
            <source>Coolant</source>
            <translation>Refrigeração</translation>
        </message>
        <message>
            <source>Copy of {0}</source>
            <translation>Cópia de {0}</translation>
        </message>
        <message>
            <source>Copy…</source>
            <translation>Copiar…</translation>
        </message>
        <message>
            <source>Core diameter</source>
            <translation>Diâmetro do núcleo</translation>
        </message>
        <message>
            <source>Corner angle</source>
            <translation>Ângulo do canto</translation>
        </message>
        <message>
            <source>Corner distance</source>
            <translation>Distância do canto</translation>
        </message>
        <message>
            <source>Corner dwell</source>
            <translation>Pausa no canto</translation>
        </message>
        <message>
            <source>Corner radius</source>
            <translation>Raio de canto</translation>
        </message>
        <message>
            <source>Corners</source>
            <translation>Cantos</translation>
        </message>
        <message>
            <source>Corners above</source>
            <translation>Cantos acima de</translation>
        </message>
        <message>
            <source>Corners that turn by more are cut slowly; 0: none</source>
            <translation>Cantos que viram mais são cortados devagar; 0: nenhum</translation>
        </message>
        <message>
            <source>Correct the marked fields first.</source>
            <translation>Corrija primeiro o que está marcado.</translation>
        </message>
        <message>
            <source>Count</source>
            <translation>Quantidade</translation>
        </message>
        <message>
            <source>Crescent</source>
            <translation>Meia-lua</translation>
        </message>
        <message>
            <source>Cross</source>
            <translation>Cruz</translation>
        </message>
        <message>
            <source>Currency</source>
            <translation>Moeda</translation>
        </message>
        <message>
            <source>Current</source>
            <translation>Corrente</translation>
        </message>
        <message>
            <source>Curves</source>
            <translation>Curvas</translation>
        </message>
        <message>
            <source>Cut</source>
            <translation>Corte</translation>
        </message>
        <message>
            <source>Cut chart</source>
            <translation>Tabela de corte</translation>
        </message>
        <message>
            <source>Cut charts (*.toml *.cfg)</source>
            <translation>Tabelas de corte (*.toml *.cfg)</translation>
        </message>
        <message>
            <source>Cut height</source>
            <translation>Altura de corte</translation>
        </message>
        <message>
            <source>Cut in this order; unchecked operations are left out of the program</source>
            <translation>Usinadas nesta ordem; o que não está marcado fica fora do programa</translation>
        </message>
        <message>
            <source>Cut it after the one below</source>
            <translation>Usinar depois da seguinte</translation>
        </message>
        <message>
            <source>Cut it before the one above</source>
            <translation>Usinar antes da anterior</translation>
        </message>
        <message>
            <source>Cut length</source>
            <translation>Comprimento do corte</translation>
        </message>
        <message>
            <source>Cut off at the right angle</source>
            <translation>Corte no ângulo reto</translation>
        </message>
        <message>
            <source>Cutting</source>
            <translation>Corte</translation>
        </message>
        <message>
            <source>Cutting the part…</source>
            <translation>Usinando a peça…</translation>
        </message>
        <message>
            <source>Cutting…</source>
            <translation>Cortando…</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Ciclo</translation>
        </message>
        <message>
            <source>D-hole</source>
            <translation>Furo em D</translation>
        </message>
        <message>
            <source>Damaged</source>
            <translation>Danificado</translation>
        </message>
        <message>
            <source>Debounce</source>
            <translation>Filtro de repique</translation>
        </message>
        <message>
            <source>Degrees, counter-clockwise</source>
            <translation>Graus, anti-horário</translation>
        </message>
        <message>
            <source>Delete a point</source>
            <translation>Excluir um ponto</translation>
        </message>
        <message>
            <source>Delete the marked tool</source>
            <translation>Exclui a ferramenta marcada</translation>
        </message>
        <message>
            <source>Deleted drawing</source>
            <translation>Desenho excluído</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>Profundidade</translation>
        </message>
        <message>
            <source>Depth to</source>
            <translation>Profundidade até</translation>
        </message>
        <message>
            <source>Device</source>
            <translation>Dispositivo</translation>
        </message>
        <message>
            <source>Dial</source>
            <translation>Relógio comparador</translation>
        </message>
        <message>
            <source>Dialect</source>
            <translation>Dialeto</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>Diâmetro</translation>
        </message>
        <message>
            <source>Diameter and height</source>
            <translation>Diâmetro e altura</translation>
        </message>
        <message>
            <source>Diameter cut away</source>
            <translation>Diâmetro retirado</translation>
        </message>
        <message>
            <source>Diameter of its middle line</source>
            <translation>Diâmetro da linha média</translation>
        </message>
        <message>
            <source>Diameter of the bolt circle</source>
            <translation>Diâmetro do círculo de furos</translation>
        </message>
        <message>
            <source>Diameter of the disc</source>
            <translation>Diâmetro do disco</translation>
        </message>
        <message>
            <source>Diameter of the holes</source>
            <translation>Diâmetro dos furos</translation>
        </message>
        <message>
            <source>Diameter of the inner corners</source>
            <translation>Diâmetro dos cantos internos</translation>
        </message>
        <message>
            <source>Diameter of the notches</source>
            <translation>Diâmetro dos entalhes</translation>
        </message>
        <message>
            <source>Diameter of the points</source>
            <translation>Diâmetro das pontas</translation>
        </message>
        <message>
            <source>Diameter through the holes</source>
            <translation>Diâmetro pelos furos</translation>
        </message>
        <message>
            <source>Dimensions</source>
            <translation>Dimensões</translation>
        </message>
        <message>
            <source>Direction</source>
            <translation>Sentido</translation>
        </message>
        <message>
            <source>Direction before step</source>
            <translation>Direção antes do passo</translation>
        </message>
        <message>
            <source>Discard</source>
            <translation>Descartar</translation>
        </message>
        <message>
            <source>Disconnect</source>
            <translation>Desconectar</translation>
        </message>
        <message>
            <source>Disconnect first: the dock is connected to this machine.</source>
            <translation>Desconecte antes: é a isto que o painel está conectado.</translation>
        </message>
        <message>
            <source>Disconnect from the controller.</source>
            <translation>Libera o controlador.</translation>
        </message>
        <message>
            <source>Distance</source>
            <translation>Distância</translation>
        </message>
        <message>
            <source>Distance of both</source>
            <translation>Distância entre os dois</translation>
        </message>
        <message>
            <source>Distance of the holes</source>
            <translation>Distância entre os furos</translation>
        </message>
        <message>
            <source>Does</source>
            <translation>Faz</translation>
        </message>
        <message>
            <source>Dog-bones</source>
            <translation>Alívio de cantos</translation>
        </message>
        <message>
            <source>Done</source>
            <translation>Concluído</translation>
        </message>
        <message>
            <source>Door</source>
            <translation>Porta</translation>
        </message>
        <message>
            <source>Double D-hole</source>
            <translation>Furo em duplo D</translation>
        </message>
        <message>
            <source>Doubles</source>
            <translation>Duplicadas</translation>
        </message>
        <message>
            <source>Drag a point to move it, the line to add one; Delete takes the point under the pointer. Esc: done.</source>
            <translation>Arraste um ponto para movê-lo, a linha para adicionar um; Delete exclui o ponto sob o cursor. Esc: terminar.</translation>
        </message>
        <message>
            <source>Drag knife</source>
            <translation>Faca de arrasto</translation>
        </message>
        <message>
            <source>Draw a freehand line</source>
            <translation>Desenhar linha à mão livre</translation>
        </message>
        <message>
            <source>Draw a line: press the left button, move, release. Shift: straight. Esc: end drawing.</source>
            <translation>Desenhe uma linha: pressione o botão esquerdo, mova, solte. Shift: reta. Esc: encerrar o desenho.</translation>
        </message>
        <message>
            <source>Drawing</source>
            <translation>Desenho</translation>
        </message>
        <message>
            <source>Drawing, solid or picture</source>
            <translation>Desenho, sólido ou imagem</translation>
        </message>
        <message>
            <source>Drawings</source>
            <translation>Desenhos</translation>
        </message>
        <message>
            <source>Drawings ({0})</source>
            <translation>Desenhos ({0})</translation>
        </message>
        <message>
            <source>Drawn twice</source>
            <translation>Desenhado duas vezes</translation>
        </message>
        <message>
            <source>Drilling</source>
            <translation>Furação</translation>
        </message>
        <message>
            <source>Drive (steps per mm follow from it)</source>
            <translation>Acionamento (dele seguem os passos por mm)</translation>
        </message>
        <message>
            <source>Drive the length</source>
            <translation>Percorrer o comprimento</translation>
        </message>
        <message>
            <source>Drop</source>
            <translation>Gota</translation>
        </message>
        <message>
            <source>Duplicate operations</source>
            <translation>Duplicar operações</translation>
        </message>
        <message>
            <source>Dynamic power</source>
            <translation>Potência dinâmica</translation>
        </message>
        <message>
            <source>EPP foam</source>
            <translation>espuma de EPP</translation>
        </message>
        <message>
            <source>EPS foam</source>
            <translation>isopor (EPS)</translation>
        </message>
        <message>
            <source>Earlier</source>
            <translation>Antes</translation>
        </message>
        <message>
            <source>Edge margin</source>
            <translation>Margem da borda</translation>
        </message>
        <message>
            <source>Edit</source>
            <translation>Editar</translation>
        </message>
        <message>
            <source>Edit program</source>
            <translation>Editar programa</translation>
        </message>
        <message>
            <source>Edit {0}</source>
            <translation>Editar {0}</translation>
        </message>
        <message>
            <source>Efficiency</source>
            <translation>Rendimento</translation>
        </message>
        <message>
            <source>Elapsed</source>
            <translation>Decorrido</translation>
        </message>
        <message>
            <source>Ellipse</source>
            <translation>Elipse</translation>
        </message>
        <message>
            <source>Elliptical pocket</source>
            <translation>Bolsão elíptico</translation>
        </message>
        <message>
            <source>Enable before step</source>
            <translation>Habilitação antes do passo</translation>
        </message>
        <message>
            <source>Encoder (closed loop)</source>
            <translation>Encoder (malha fechada)</translation>
        </message>
        <message>
            <source>Encoder's gear</source>
            <translation>Redução do encoder</translation>
        </message>
        <message>
            <source>Encoder's pulses</source>
            <translation>Pulsos do encoder</translation>
        </message>
        <message>
            <source>End angle</source>
            <translation>Ângulo final</translation>
        </message>
        <message>
            <source>Ends joined</source>
            <translation>Pontas unidas</translation>
        </message>
        <message>
            <source>Ends of the legs</source>
            <translation>Pontas das abas</translation>
        </message>
        <message>
            <source>Ends that are nearer than this are moved together</source>
            <translation>Pontas mais próximas que isto são unidas</translation>
        </message>
        <message>
            <source>Engagement</source>
            <translation>Engajamento</translation>
        </message>
        <message>
            <source>Engraving</source>
            <translation>Gravação</translation>
        </message>
        <message>
            <source>Enter from</source>
            <translation>Entra por</translation>
        </message>
        <message>
            <source>Entry</source>
            <translation>Entrada</translation>
        </message>
        <message>
            <source>Entry angle</source>
            <translation>Ângulo de entrada</translation>
        </message>
        <message>
            <source>Entry from</source>
            <translation>Vem de</translation>
        </message>
        <message>
            <source>Entry slit</source>
            <translation>Fenda de entrada</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>Erro</translation>
        </message>
        <message>
            <source>Every job with a journal was cut to its end.</source>
            <translation>Todo trabalho cujo diário está guardado foi cortado até o fim.</translation>
        </message>
        <message>
            <source>Exit of the wire: back along its entry, or the shortest way to an edge</source>
            <translation>Como o fio sai no fim: de volta pelo mesmo caminho, ou pelo caminho mais curto até uma borda</translation>
        </message>
        <message>
            <source>Export job</source>
            <translation>Exportar trabalho</translation>
        </message>
        <message>
            <source>Extra depth, so that the tool comes out below</source>
            <translation>Quanto a ferramenta desce a mais para sair por baixo</translation>
        </message>
        <message>
            <source>Eye</source>
            <translation>Olhal</translation>
        </message>
        <message>
            <source>Eye plate</source>
            <translation>Chapa com olhal</translation>
        </message>
        <message>
            <source>Eyes</source>
            <translation>Olhais</translation>
        </message>
        <message>
            <source>F is the feed per minute</source>
            <translation>F é o avanço por minuto</translation>
        </message>
        <message>
            <source>F is the feed per turn of the spindle</source>
            <translation>F é o avanço por volta do fuso</translation>
        </message>
        <message>
            <source>F is the inverse of a move's time in minutes</source>
            <translation>F é um dividido pelos minutos que o movimento dura</translation>
        </message>
        <message>
            <source>FR4 (glass fibre)</source>
            <translation>FR4 (fibra de vidro)</translation>
        </message>
        <message>
            <source>Facing</source>
            <translation>Faceamento</translation>
        </message>
        <message>
            <source>Failed</source>
            <translation>Falhou</translation>
        </message>
        <message>
            <source>Family</source>
            <translation>Família</translation>
        </message>
        <message>
            <source>Faults</source>
            <translation>Falhas</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>Avanço</translation>
        </message>
        <message>
            <source>Feed at corners</source>
            <translation>Avanço nos cantos</translation>
        </message>
        <message>
            <source>Feed of arcs</source>
            <translation>Avanço dos arcos</translation>
        </message>
        <message>
            <source>Feed of holes</source>
            <translation>Avanço dos furos</translation>
        </message>
        <message>
            <source>Feed without F</source>
            <translation>Avanço sem F</translation>
        </message>
        <message>
            <source>Feeding in air</source>
            <translation>Avanço no ar</translation>
        </message>
        <message>
            <source>Feeds by a factor…</source>
            <translation>Avanços por um fator…</translation>
        </message>
        <message>
            <source>Feeds times</source>
            <translation>Avanços vezes</translation>
        </message>
        <message>
            <source>Figures</source>
            <translation>Valores</translation>
        </message>
        <message>
            <source>File</source>
            <translation>Arquivo</translation>
        </message>
        <message>
            <source>Find</source>
            <translation>Localizar</translation>
        </message>
        <message>
            <source>Find the cause, then home the machine or unlock it.</source>
            <translation>Encontre a causa, depois referencie a máquina ou destrave-a.</translation>
        </message>
        <message>
            <source>Findings ({0})</source>
            <translation>Ocorrências ({0})</translation>
        </message>
        <message>
            <source>Findings ({0}): the program must not be sent</source>
            <translation>Ocorrências ({0}): o programa não pode ser enviado</translation>
        </message>
        <message>
            <source>Finds and replaces (Ctrl+F)</source>
            <translation>Localiza e substitui (Ctrl+F)</translation>
        </message>
        <message>
            <source>Finish</source>
            <translation>Acabamento</translation>
        </message>
        <message>
            <source>Finishing</source>
            <translation>Terminando</translation>
        </message>
        <message>
            <source>First corner</source>
            <translation>Primeiro canto</translation>
        </message>
        <message>
            <source>First eye</source>
            <translation>Primeiro olhal</translation>
        </message>
        <message>
            <source>First hole</source>
            <translation>Primeiro furo</translation>
        </message>
        <message>
            <source>First hole at</source>
            <translation>Primeiro furo em</translation>
        </message>
        <message>
            <source>First number</source>
            <translation>Primeiro número</translation>
        </message>
        <message>
            <source>First wait</source>
            <translation>Primeira espera</translation>
        </message>
        <message>
            <source>Fit to drawing</source>
            <translation>Ajustar ao desenho</translation>
        </message>
        <message>
            <source>Fitting arcs…</source>
            <translation>Ajustando arcos…</translation>
        </message>
        <message>
            <source>Flange</source>
            <translation>Flange</translation>
        </message>
        <message>
            <source>Flanges and plates</source>
            <translation>Flanges e chapas</translation>
        </message>
        <message>
            <source>Flood</source>
            <translation>Jorro</translation>
        </message>
        <message>
            <source>Flute length</source>
            <translation>Comprimento de corte</translation>
        </message>
        <message>
            <source>Flutes</source>
            <translation>Dentes</translation>
        </message>
        <message>
            <source>Follow only the selected lines</source>
            <translation>Seguir o que está selecionado, e nada mais</translation>
        </message>
        <message>
            <source>Follow the drawing that is selected in the tree or in the 3D view</source>
            <translation>Seguir o desenho selecionado na árvore ou na vista 3D</translation>
        </message>
        <message>
            <source>Font</source>
            <translation>Fonte</translation>
        </message>
        <message>
            <source>Font file</source>
            <translation>Arquivo da fonte</translation>
        </message>
        <message>
            <source>For a board that receives bytes: 0 to 3, or unused for a motor without an axis</source>
            <translation>De uma placa que recebe bytes: 0 a 3, ou unused para um motor sem eixo</translation>
        </message>
        <message>
            <source>For a mill that does not cut over its centre; 0: 10°</source>
            <translation>Para uma fresa sem corte no centro; 0: 10°</translation>
        </message>
        <message>
            <source>Force</source>
            <translation>Força</translation>
        </message>
        <message>
            <source>Form</source>
            <translation>Forma</translation>
        </message>
        <message>
            <source>Forward</source>
            <translation>Avançar</translation>
        </message>
        <message>
            <source>Free length</source>
            <translation>Comprimento livre</translation>
        </message>
        <message>
            <source>Free to jog</source>
            <translation>Liberar o movimento</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks numba. All works without, but planning and simulating are slow.</source>
            <translation>Falta numba no Python do FreeCAD. Tudo funciona sem ele, mas o planejamento e a simulação ficam lentos.</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}</source>
            <translation>Falta no Python do FreeCAD: {0}</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}. No machine can be reached without.</source>
            <translation>Falta {0} ao Python do FreeCAD. Sem isso nenhuma máquina pode ser alcançada.</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}. No program can be made without.</source>
            <translation>Falta no Python do FreeCAD: {0}. Sem isso não é possível gerar programas.</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}. Some files cannot be read without.</source>
            <translation>Falta {0} ao Python do FreeCAD. Sem isso alguns arquivos não podem ser lidos.</translation>
        </message>
        <message>
            <source>From</source>
            <translation>De</translation>
        </message>
        <message>
            <source>From X to the ellipse's first axis</source>
            <translation>De X até o primeiro eixo da elipse</translation>
        </message>
        <message>
            <source>From X to the first hole, counter-clockwise</source>
            <translation>De X ao primeiro furo, no sentido anti-horário</translation>
        </message>
        <message>
            <source>From X to the last hole</source>
            <translation>De X ao último furo</translation>
        </message>
        <message>
            <source>From X to the lines of the pattern</source>
            <translation>De X às linhas do padrão</translation>
        </message>
        <message>
            <source>From above</source>
            <translation>De cima</translation>
        </message>
        <message>
            <source>From below</source>
            <translation>De baixo</translation>
        </message>
        <message>
            <source>From chart</source>
            <translation>Da tabela</translation>
        </message>
        <message>
            <source>From contour {0}</source>
            <translation>A partir do contorno {0}</translation>
        </message>
        <message>
            <source>From here down the tool feeds</source>
            <translation>Daqui para baixo a ferramenta avança em velocidade de corte</translation>
        </message>
        <message>
            <source>From hole to hole along X and along Y</source>
            <translation>De furo a furo ao longo de X e ao longo de Y</translation>
        </message>
        <message>
            <source>From line {0}</source>
            <translation>A partir da linha {0}</translation>
        </message>
        <message>
            <source>From line {0}, the time that it is run: {1}</source>
            <translation>A partir da linha {0}, na vez em que é executada: {1}</translation>
        </message>
        <message>
            <source>From one to the next</source>
            <translation>De um ao seguinte</translation>
        </message>
        <message>
            <source>From one turn of the thread to the next</source>
            <translation>De uma volta da rosca à seguinte</translation>
        </message>
        <message>
            <source>From the base to the eye's middle</source>
            <translation>Da base ao centro do olhal</translation>
        </message>
        <message>
            <source>From the bore's bottom to the keyway's</source>
            <translation>Do fundo do furo ao fundo do rasgo</translation>
        </message>
        <message>
            <source>From the circle's middle to the slot's end</source>
            <translation>Do centro do círculo à ponta do rasgo</translation>
        </message>
        <message>
            <source>From the edges to the holes</source>
            <translation>Das bordas aos furos</translation>
        </message>
        <message>
            <source>From the middle of the circle to the holes</source>
            <translation>Do meio do círculo até os furos</translation>
        </message>
        <message>
            <source>From the middle to the point</source>
            <translation>Do centro à ponta</translation>
        </message>
        <message>
            <source>From the operation {0}</source>
            <translation>A partir da operação {0}</translation>
        </message>
        <message>
            <source>From the place that was clicked, {0}</source>
            <translation>A partir do lugar clicado, {0}</translation>
        </message>
        <message>
            <source>From the tip to the holder; 0: not given</source>
            <translation>Da ponta ao porta-ferramenta; 0: não informado</translation>
        </message>
        <message>
            <source>From tooth to tooth</source>
            <translation>De dente a dente</translation>
        </message>
        <message>
            <source>Full steps a turn</source>
            <translation>Passos inteiros por volta</translation>
        </message>
        <message>
            <source>F{0} in/min</source>
            <translation>F{0} pol/min</translation>
        </message>
        <message>
            <source>F{0} in/rev</source>
            <translation>F{0} pol/volta</translation>
        </message>
        <message>
            <source>F{0} mm/min</source>
            <translation>F{0} mm/min</translation>
        </message>
        <message>
            <source>F{0} mm/rev</source>
            <translation>F{0} mm/volta</translation>
        </message>
        <message>
            <source>G73 pecks, chips</source>
            <translation>G73 quebra-cavaco</translation>
        </message>
        <message>
            <source>G81 straight</source>
            <translation>G81 direta</translation>
        </message>
        <message>
            <source>G82 with a pause</source>
            <translation>G82 com pausa</translation>
        </message>
        <message>
            <source>G83 pecks, all out</source>
            <translation>G83 bicadas</translation>
        </message>
        <message>
            <source>G98 clearance</source>
            <translation>G98 segurança</translation>
        </message>
        <message>
            <source>G99 retract</source>
            <translation>G99 recuo</translation>
        </message>
        <message>
            <source>Gap</source>
            <translation>Vão</translation>
        </message>
        <message>
            <source>Gap closed</source>
            <translation>Vão fechado</translation>
        </message>
        <message>
            <source>Gaps up to this are closed</source>
            <translation>Vãos até isto são fechados</translation>
        </message>
        <message>
            <source>Gear ratio</source>
            <translation>Redução</translation>
        </message>
        <message>
            <source>General</source>
            <translation>Geral</translation>
        </message>
        <message>
            <source>Go back along the cut by this length; a machine that moves is held first.</source>
            <translation>Volta este comprimento ao longo do corte; uma máquina em movimento é parada antes.</translation>
        </message>
        <message>
            <source>Go back to where the tool last began to go down into the work.</source>
            <translation>Volta até onde a ferramenta começou a descer na peça pela última vez.</translation>
        </message>
        <message>
            <source>Go back to where this line of the program begins, its last run before here.</source>
            <translation>Volta até onde esta linha do programa começa, na última passagem antes daqui.</translation>
        </message>
        <message>
            <source>Go forward along the cut by this length, at most to where it was held.</source>
            <translation>Avança de novo este comprimento ao longo do corte, no máximo até onde ele tinha chegado.</translation>
        </message>
        <message>
            <source>Go on</source>
            <translation>Continuar</translation>
        </message>
        <message>
            <source>Go up to this Z first; where none is given: the program's highest crossing rapid</source>
            <translation>Subir primeiro até este Z; sem valor: a travessia rápida mais alta do programa</translation>
        </message>
        <message>
            <source>Goes back by</source>
            <translation>Volta</translation>
        </message>
        <message>
            <source>Goes on with</source>
            <translation>Continua com</translation>
        </message>
        <message>
            <source>Good side</source>
            <translation>Lado bom</translation>
        </message>
        <message>
            <source>Greatest chip load</source>
            <translation>Avanço por dente máximo</translation>
        </message>
        <message>
            <source>Greatest engagement</source>
            <translation>Ângulo de contato máximo</translation>
        </message>
        <message>
            <source>Grey values are from the chart; typed values replace them</source>
            <translation>Valores em cinza são da tabela; o que você digita prevalece</translation>
        </message>
        <message>
            <source>Gusset</source>
            <translation>Esquadro de reforço</translation>
        </message>
        <message>
            <source>H-profile</source>
            <translation>Perfil H</translation>
        </message>
        <message>
            <source>HDPE plastic</source>
            <translation>plástico PEAD</translation>
        </message>
        <message>
            <source>Half the width along its second axis</source>
            <translation>Metade da largura ao longo do segundo eixo</translation>
        </message>
        <message>
            <source>Half the width along the ellipse's first axis</source>
            <translation>Metade da largura ao longo do primeiro eixo da elipse</translation>
        </message>
        <message>
            <source>Half the width of the pocket</source>
            <translation>Metade da largura do bolsão</translation>
        </message>
        <message>
            <source>Hand</source>
            <translation>Sentido da rosca</translation>
        </message>
        <message>
            <source>Heart</source>
            <translation>Coração</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>Altura</translation>
        </message>
        <message>
            <source>Height above the top of the stock; lines: where the tool's tip goes</source>
            <translation>Altura acima do topo do bloco; linhas: por onde passa a ponta da ferramenta</translation>
        </message>
        <message>
            <source>Height below the notch</source>
            <translation>Altura abaixo do entalhe</translation>
        </message>
        <message>
            <source>Height of</source>
            <translation>Altura de</translation>
        </message>
        <message>
            <source>Height of the head</source>
            <translation>Altura da cabeça</translation>
        </message>
        <message>
            <source>Height of the plate above the middle</source>
            <translation>Altura da chapa acima do centro</translation>
        </message>
        <message>
            <source>Height of the teeth</source>
            <translation>Altura dos dentes</translation>
        </message>
        <message>
            <source>Heights</source>
            <translation>Alturas</translation>
        </message>
        <message>
            <source>Held</source>
            <translation>Em pausa</translation>
        </message>
        <message>
            <source>Highest feed</source>
            <translation>Avanço máximo</translation>
        </message>
        <message>
            <source>Highest speed</source>
            <translation>Velocidade máxima</translation>
        </message>
        <message>
            <source>Highest spindle speed</source>
            <translation>Rotação máxima</translation>
        </message>
        <message>
            <source>Hold</source>
            <translation>Pausar</translation>
        </message>
        <message>
            <source>Hold: slow down and stop on the path; nothing is lost, the spindle keeps turning.</source>
            <translation>Pausar: desacelera e fica parada; nada se perde, o spindle continua girando.</translation>
        </message>
        <message>
            <source>Holder diameter</source>
            <translation>Diâmetro do porta-ferramenta</translation>
        </message>
        <message>
            <source>Holding…</source>
            <translation>Pausando…</translation>
        </message>
        <message>
            <source>Hole</source>
            <translation>Furo</translation>
        </message>
        <message>
            <source>Hole for the head</source>
            <translation>Furo para a cabeça</translation>
        </message>
        <message>
            <source>Holes</source>
            <translation>Furos</translation>
        </message>
        <message>
            <source>Holes below</source>
            <translation>Furos abaixo de</translation>
        </message>
        <message>
            <source>Holes of a smaller diameter are cut slowly; 0: none by diameter</source>
            <translation>Furos de diâmetro menor são cortados devagar; 0: nenhum pelo diâmetro</translation>
        </message>
        <message>
            <source>Holes of a smaller diameter get a spot at their centre, no cut</source>
            <translation>Furos de diâmetro menor recebem um ponto no centro, sem corte</translation>
        </message>
        <message>
            <source>Holes with a shorter outline are cut slowly; 0: none by length</source>
            <translation>Furos de contorno mais curto são cortados devagar; 0: nenhum pelo comprimento</translation>
        </message>
        <message>
            <source>Holes; 0: none</source>
            <translation>Furos; 0: nenhum</translation>
        </message>
        <message>
            <source>Home</source>
            <translation>Referenciar</translation>
        </message>
        <message>
            <source>Home the machine: it finds its zero with its limit switches.</source>
            <translation>Deixa a máquina encontrar o próprio zero com os fins de curso.</translation>
        </message>
        <message>
            <source>Homing</source>
            <translation>Referenciando</translation>
        </message>
        <message>
            <source>Homing switch</source>
            <translation>Chave de referência</translation>
        </message>
        <message>
            <source>Homing works only while the machine is idle or in alarm.</source>
            <translation>Só é possível referenciar com a máquina pronta ou em alarme.</translation>
        </message>
        <message>
            <source>Hook</source>
            <translation>Gancho</translation>
        </message>
        <message>
            <source>Hot wire</source>
            <translation>Fio quente</translation>
        </message>
        <message>
            <source>How deep a knife or point goes; 0: through the sheet, a point 0.2 mm</source>
            <translation>A profundidade de faca ou ponta; 0: através da chapa, a ponta 0,2 mm</translation>
        </message>
        <message>
            <source>How deep one peck goes</source>
            <translation>Quanto desce cada bicada</translation>
        </message>
        <message>
            <source>How far a closed cut is followed with power beyond its begin</source>
            <translation>Quanto um corte fechado segue com potência além do início</translation>
        </message>
        <message>
            <source>How far a closed line is followed beyond its begin</source>
            <translation>Quanto se segue uma linha fechada além do seu começo</translation>
        </message>
        <message>
            <source>How far a drag knife's edge trails behind its axis</source>
            <translation>Quanto o fio da faca de arrasto fica atrás do seu eixo</translation>
        </message>
        <message>
            <source>How far a pierce stays from parts and cut edges; 0: that of the cut chart</source>
            <translation>Quanto a perfuração se afasta de peças e bordas cortadas; 0: o da tabela de corte</translation>
        </message>
        <message>
            <source>How far above it the letters stand</source>
            <translation>A que distância acima dela ficam as letras</translation>
        </message>
        <message>
            <source>How far an arc turns, or how far a line leans away from the contour</source>
            <translation>Quanto um arco gira, ou quanto uma linha se afasta do contorno</translation>
        </message>
        <message>
            <source>How far apart joints are at most</source>
            <translation>A maior distância entre as pontes</translation>
        </message>
        <message>
            <source>How far apart tabs are at most</source>
            <translation>A distância máxima entre as pontes</translation>
        </message>
        <message>
            <source>How far before and behind a corner</source>
            <translation>Quanto antes e depois de um canto</translation>
        </message>
        <message>
            <source>How far before and behind a corner the feed is lower; 0: it is not</source>
            <translation>Até que distância antes e depois do canto o avanço é menor; 0: não é</translation>
        </message>
        <message>
            <source>How far before its end the cut runs on without power</source>
            <translation>A que distância do fim o corte segue sem potência</translation>
        </message>
        <message>
            <source>How far behind the pierce the power is full</source>
            <translation>A que distância da perfuração a potência é plena</translation>
        </message>
        <message>
            <source>How far from the stock's edge cuts must stay; 0: the edge does not matter</source>
            <translation>A que distância da borda do bloco os cortes devem ficar; 0: a borda não importa</translation>
        </message>
        <message>
            <source>How far letters lean to the right</source>
            <translation>Quanto as letras se inclinam para a direita</translation>
        </message>
        <message>
            <source>How far lines and arcs may leave other curves</source>
            <translation>Quanto linhas e arcos podem se afastar de outras curvas</translation>
        </message>
        <message>
            <source>How far lines and arcs may leave the letters</source>
            <translation>Quanto linhas e arcos podem se afastar das letras</translation>
        </message>
        <message>
            <source>How far lines and arcs may leave the pixels; 0: half a pixel</source>
            <translation>Quanto linhas e arcos podem se afastar dos pixels; 0: meio pixel</translation>
        </message>
        <message>
            <source>How far one click goes along the cut.</source>
            <translation>Quanto um clique avança ao longo do corte.</translation>
        </message>
        <message>
            <source>How far one click moves the machine.</source>
            <translation>Quanto um clique move a máquina.</translation>
        </message>
        <message>
            <source>How far one turn of the helix falls</source>
            <translation>Quanto desce uma volta da hélice</translation>
        </message>
        <message>
            <source>How far the arc goes; below 0 clockwise, with the letters outside</source>
            <translation>Até onde vai o arco; abaixo de 0 no sentido horário, com as letras por fora</translation>
        </message>
        <message>
            <source>How far the axis goes</source>
            <translation>Quanto o eixo percorre</translation>
        </message>
        <message>
            <source>How far the cut may be off the drawing</source>
            <translation>Quanto o corte pode se afastar do desenho</translation>
        </message>
        <message>
            <source>How far the kerf of a way through the scrap stays from every part</source>
            <translation>Quanto o corte de um caminho pelo retalho se afasta de cada peça</translation>
        </message>
        <message>
            <source>How far the path may be off an ellipse or a B-spline; lines and arcs are exact</source>
            <translation>Quanto a trajetória pode desviar de uma elipse ou B-spline; retas e arcos são exatos</translation>
        </message>
        <message>
            <source>How far the tool's rim runs over the edge</source>
            <translation>Quanto a borda da ferramenta passa da aresta</translation>
        </message>
        <message>
            <source>How far the torch runs on over the begin of the cut without power</source>
            <translation>Quanto a tocha segue sobre o início do corte sem potência</translation>
        </message>
        <message>
            <source>How far the wall may be off the drawing</source>
            <translation>Quanto a parede pode se afastar do desenho</translation>
        </message>
        <message>
            <source>How fast the axis goes</source>
            <translation>Com que velocidade o eixo anda</translation>
        </message>
        <message>
            <source>How fast the machine moves while jogging; it never goes faster than it can.</source>
            <translation>Velocidade da máquina no movimento manual; nunca acima do que ela pode.</translation>
        </message>
        <message>
            <source>How high a tab is above the bottom of the cut</source>
            <translation>A altura de uma ponte acima do fundo do corte</translation>
        </message>
        <message>
            <source>How is {0} cut?</source>
            <translation>Como {0} é cortado?</translation>
        </message>
        <message>
            <source>How it is cut; the machine must be able to</source>
            <translation>Como se corta; a máquina precisa ser capaz disso</translation>
        </message>
        <message>
            <source>How it was read last</source>
            <translation>Como foi lido por último</translation>
        </message>
        <message>
            <source>How long a spot has power</source>
            <translation>Quanto tempo um ponto tem potência</translation>
        </message>
        <message>
            <source>How long the flame heats before the pierce; 0: that of the chart</source>
            <translation>Quanto tempo a chama aquece antes da perfuração; 0: o da tabela</translation>
        </message>
        <message>
            <source>How many corners and narrow places the tool does not reach into</source>
            <translation>Em quantos cantos e lugares estreitos a ferramenta não entra</translation>
        </message>
        <message>
            <source>How many gaps, doubles, crossings and other faults were found</source>
            <translation>Quantos vãos, duplicadas, cruzamentos e outras falhas foram achados</translation>
        </message>
        <message>
            <source>How many holes</source>
            <translation>Quantos furos</translation>
        </message>
        <message>
            <source>How many holes along X</source>
            <translation>Quantos furos ao longo de X</translation>
        </message>
        <message>
            <source>How many holes along Y</source>
            <translation>Quantos furos ao longo de Y</translation>
        </message>
        <message>
            <source>How many holes are made</source>
            <translation>Quantos furos são feitos</translation>
        </message>
        <message>
            <source>How many joints on each outline</source>
            <translation>Quantas pontes em cada contorno</translation>
        </message>
        <message>
            <source>How many parts are cut free</source>
            <translation>Quantas peças são soltas</translation>
        </message>
        <message>
            <source>How many passes at each depth</source>
            <translation>Número de passes em cada profundidade</translation>
        </message>
        <message>
            <source>How many passes in depth</source>
            <translation>Número de passes em profundidade</translation>
        </message>
        <message>
            <source>How many points the wire has</source>
            <translation>Número de pontos do arame</translation>
        </message>
        <message>
            <source>How many tabs hold the part</source>
            <translation>Quantas pontes seguram a peça</translation>
        </message>
        <message>
            <source>How many tabs on each line</source>
            <translation>Quantas pontes em cada linha</translation>
        </message>
        <message>
            <source>How many teeth; 0: not given</source>
            <translation>Quantos dentes; 0: não informado</translation>
        </message>
        <message>
            <source>How many there are</source>
            <translation>Quantos há</translation>
        </message>
        <message>
            <source>How many there are: one, or one a tool in turn</source>
            <translation>Quantos são: um, ou um por ferramenta na sequência</translation>
        </message>
        <message>
            <source>How many times faster than a real one the virtual machine moves</source>
            <translation>Quantas vezes mais rápido que uma real a máquina virtual se move</translation>
        </message>
        <message>
            <source>How many times faster than the machine</source>
            <translation>Quantas vezes mais rápido que a máquina</translation>
        </message>
        <message>
            <source>How many turns the thread has</source>
            <translation>Quantas voltas a rosca tem</translation>
        </message>
        <message>
            <source>How much of the rim may be in the material at most, as an angle</source>
            <translation>Quanto da borda pode estar no material no máximo, como ângulo</translation>
        </message>
        <message>
            <source>How much of the rim may be in the material, as an angle; 0: not given</source>
            <translation>Quanto do contorno pode estar no material, em ângulo; 0: não informado</translation>
        </message>
        <message>
            <source>How often each line is cut</source>
            <translation>Quantas vezes cada linha é cortada</translation>
        </message>
        <message>
            <source>How often the tool pierces</source>
            <translation>Quantas vezes a ferramenta perfura</translation>
        </message>
        <message>
            <source>How steeply a helix or ramp goes down</source>
            <translation>Inclinação com que a hélice ou rampa desce</translation>
        </message>
        <message>
            <source>How steeply the tool goes down along the line; 0: straight down</source>
            <translation>Com que inclinação a ferramenta desce ao longo da linha; 0: na vertical</translation>
        </message>
        <message>
            <source>How the area is cleared</source>
            <translation>Como a área é esvaziada</translation>
        </message>
        <message>
            <source>How the cutter turns against the feed</source>
            <translation>Como a fresa gira em relação ao avanço</translation>
        </message>
        <message>
            <source>How the drill goes down</source>
            <translation>Como a broca desce</translation>
        </message>
        <message>
            <source>How the thread winds</source>
            <translation>Para que lado a rosca gira</translation>
        </message>
        <message>
            <source>How the tool comes to the contour</source>
            <translation>Como a ferramenta chega ao contorno</translation>
        </message>
        <message>
            <source>How the tool goes down</source>
            <translation>Como a ferramenta desce</translation>
        </message>
        <message>
            <source>How the tool leaves the contour</source>
            <translation>Como a ferramenta deixa o contorno</translation>
        </message>
        <message>
            <source>How wide a tab is at its top</source>
            <translation>A largura de uma ponte no topo</translation>
        </message>
        <message>
            <source>How wide the material is that stays</source>
            <translation>A largura do material que fica</translation>
        </message>
        <message>
            <source>Identity</source>
            <translation>Identidade</translation>
        </message>
        <message>
            <source>Idle</source>
            <translation>Pronta</translation>
        </message>
        <message>
            <source>Import drawing</source>
            <translation>Importar desenho</translation>
        </message>
        <message>
            <source>Import tools</source>
            <translation>Importar ferramentas</translation>
        </message>
        <message>
            <source>Import…</source>
            <translation>Importar…</translation>
        </message>
        <message>
            <source>In holes, or round bosses</source>
            <translation>Em furos ou em volta de ressaltos</translation>
        </message>
        <message>
            <source>In how many steps outwards</source>
            <translation>Em quantos passos para fora</translation>
        </message>
        <message>
            <source>In machine coordinates</source>
            <translation>Em coordenadas da máquina</translation>
        </message>
        <message>
            <source>In the controller's panel choose a machine whose pulses this computer makes.</source>
            <translation>Escolha no painel do controlador uma máquina cujos pulsos este computador gera.</translation>
        </message>
        <message>
            <source>In the program</source>
            <translation>No programa</translation>
        </message>
        <message>
            <source>In whole passes</source>
            <translation>Em passes inteiros</translation>
        </message>
        <message>
            <source>Inertia</source>
            <translation>Inércia</translation>
        </message>
        <message>
            <source>Inner diameter</source>
            <translation>Diâmetro interno</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Entradas</translation>
        </message>
        <message>
            <source>Inputs that are on: {0}</source>
            <translation>Entradas ligadas: {0}</translation>
        </message>
        <message>
            <source>Inside of the hook</source>
            <translation>Interior do gancho</translation>
        </message>
        <message>
            <source>Interpolation</source>
            <translation>Interpolação</translation>
        </message>
        <message>
            <source>Interval of pulses</source>
            <translation>Intervalo dos pulsos</translation>
        </message>
        <message>
            <source>Is the work zero set on the stock, and is the path free?</source>
            <translation>O zero-peça está definido no bloco e o caminho está livre?</translation>
        </message>
        <message>
            <source>Isosceles triangle</source>
            <translation>Triângulo isósceles</translation>
        </message>
        <message>
            <source>It is cut first already</source>
            <translation>Já é usinada primeiro</translation>
        </message>
        <message>
            <source>It is cut last already</source>
            <translation>Já é usinada por último</translation>
        </message>
        <message>
            <source>It is your copy of a shipped profile, and is used in its place.</source>
            <translation>É a sua cópia de um perfil fornecido, e toma o lugar dele.</translation>
        </message>
        <message>
            <source>Its language and its link: grbl, grblhal, fluidnc, linuxcnc, thesis-a …</source>
            <translation>Sua linguagem e sua ligação: grbl, grblhal, fluidnc, linuxcnc, thesis-a …</translation>
        </message>
        <message>
            <source>Its name in job files</source>
            <translation>Seu nome nos arquivos de trabalho</translation>
        </message>
        <message>
            <source>Jerk</source>
            <translation>Jerk (arranque)</translation>
        </message>
        <message>
            <source>Job</source>
            <translation>Trabalho</translation>
        </message>
        <message>
            <source>Job: {0}</source>
            <translation>Trabalho: {0}</translation>
        </message>
        <message>
            <source>Jobs ({0})</source>
            <translation>Trabalhos ({0})</translation>
        </message>
        <message>
            <source>Jog</source>
            <translation>Movimento manual</translation>
        </message>
        <message>
            <source>Jogging</source>
            <translation>Movimento manual</translation>
        </message>
        <message>
            <source>Jogging works only while the machine is idle.</source>
            <translation>O movimento manual só funciona com a máquina pronta.</translation>
        </message>
        <message>
            <source>Join ends</source>
            <translation>Unir pontas</translation>
        </message>
        <message>
            <source>Join only lines of one colour</source>
            <translation>Unir só linhas da mesma cor</translation>
        </message>
        <message>
            <source>Joints that hold the part until it is broken out</source>
            <translation>Pontes que seguram a peça até ela ser destacada</translation>
        </message>
        <message>
            <source>Junction deviation</source>
            <translation>Desvio de junção</translation>
        </message>
        <message>
            <source>Keep as mesh</source>
            <translation>Guardar como malha</translation>
        </message>
        <message>
            <source>Keep cutting and close</source>
            <translation>Continuar usinando e fechar</translation>
        </message>
        <message>
            <source>Keep the cut part as mesh</source>
            <translation>Guardar a peça cortada como malha</translation>
        </message>
        <message>
            <source>Keeps the text where it came from (Ctrl+S); a job's is kept beside it</source>
            <translation>Guarda o texto de onde ele veio (Ctrl+S); o de um trabalho fica ao lado dele</translation>
        </message>
        <message>
            <source>Kerf</source>
            <translation>Largura do corte</translation>
        </message>
        <message>
            <source>Kerning</source>
            <translation>Kerning</translation>
        </message>
        <message>
            <source>Keyhole</source>
            <translation>Buraco de fechadura</translation>
        </message>
        <message>
            <source>Keyway bore</source>
            <translation>Furo com chaveta</translation>
        </message>
        <message>
            <source>Killed</source>
            <translation>Interrompido</translation>
        </message>
        <message>
            <source>Kind</source>
            <translation>Tipo</translation>
        </message>
        <message>
            <source>L-bracket</source>
            <translation>Suporte em L</translation>
        </message>
        <message>
            <source>Laser</source>
            <translation>Laser</translation>
        </message>
        <message>
            <source>Laser (M4 with power)</source>
            <translation>Laser (M4 com potência)</translation>
        </message>
        <message>
            <source>Last hole</source>
            <translation>Último furo</translation>
        </message>
        <message>
            <source>Last seen</source>
            <translation>Visto por último</translation>
        </message>
        <message>
            <source>Last stepdown</source>
            <translation>Última profundidade de corte</translation>
        </message>
        <message>
            <source>Last stepover</source>
            <translation>Última penetração de trabalho</translation>
        </message>
        <message>
            <source>Later</source>
            <translation>Depois</translation>
        </message>
        <message>
            <source>Lead-in</source>
            <translation>Entrada</translation>
        </message>
        <message>
            <source>Lead-out</source>
            <translation>Saída</translation>
        </message>
        <message>
            <source>Leads</source>
            <translation>Entrada e saída</translation>
        </message>
        <message>
            <source>Leads as usual for the process, or with values of your own</source>
            <translation>Entradas e saídas usuais do processo, ou com valores próprios</translation>
        </message>
        <message>
            <source>Least chip load</source>
            <translation>Avanço por dente mínimo</translation>
        </message>
        <message>
            <source>Least wait</source>
            <translation>Menor espera</translation>
        </message>
        <message>
            <source>Leave</source>
            <translation>Sai</translation>
        </message>
        <message>
            <source>Leave out of the program</source>
            <translation>Deixar fora do programa</translation>
        </message>
        <message>
            <source>Left out, it follows from the drive</source>
            <translation>Omitido, segue do acionamento</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>Comprimento livre</translation>
        </message>
        <message>
            <source>Length in</source>
            <translation>Comprimento entrada</translation>
        </message>
        <message>
            <source>Length of the head</source>
            <translation>Comprimento da cabeça</translation>
        </message>
        <message>
            <source>Length of the neck</source>
            <translation>Comprimento do pescoço</translation>
        </message>
        <message>
            <source>Length offset</source>
            <translation>Correção de comprimento</translation>
        </message>
        <message>
            <source>Length out</source>
            <translation>Comprimento saída</translation>
        </message>
        <message>
            <source>Length that the controller adds to Z, if the machine uses a table of lengths; 0: not given</source>
            <translation>O que o controlador soma a Z, onde a máquina toma os comprimentos de uma tabela; 0: não informado</translation>
        </message>
        <message>
            <source>Length, width and height; for an upright cylinder the length is its diameter</source>
            <translation>Comprimento, largura e altura; num cilindro, que fica em pé, o comprimento é o diâmetro</translation>
        </message>
        <message>
            <source>Lengths and limits</source>
            <translation>Comprimentos e limites</translation>
        </message>
        <message>
            <source>Level</source>
            <translation>Nível</translation>
        </message>
        <message>
            <source>Levels</source>
            <translation>Níveis</translation>
        </message>
        <message>
            <source>Lever</source>
            <translation>Alavanca</translation>
        </message>
        <message>
            <source>Lift before</source>
            <translation>Levantar antes</translation>
        </message>
        <message>
            <source>Light areas</source>
            <translation>Áreas claras</translation>
        </message>
        <message>
            <source>Line</source>
            <translation>Linha</translation>
        </message>
        <message>
            <source>Line at release</source>
            <translation>Linha ao soltar</translation>
        </message>
        <message>
            <source>Line by line</source>
            <translation>Linha por linha</translation>
        </message>
        <message>
            <source>Line length</source>
            <translation>Comprimento das linhas</translation>
        </message>
        <message>
            <source>Line spacing</source>
            <translation>Entrelinha</translation>
        </message>
        <message>
            <source>Line {0}, {1}: {2}</source>
            <translation>Linha {0}, {1}: {2}</translation>
        </message>
        <message>
            <source>Line {0}: {1}</source>
            <translation>Linha {0}: {1}</translation>
        </message>
        <message>
            <source>Lines</source>
            <translation>Linhas</translation>
        </message>
        <message>
            <source>Lines can be typed only while the machine is idle or in alarm.</source>
            <translation>Só se pode digitar linhas com a máquina parada ou em alarme.</translation>
        </message>
        <message>
            <source>Lines nearer than this to another one are drawn twice</source>
            <translation>Linhas mais próximas de outra que isto estão desenhadas duas vezes</translation>
        </message>
        <message>
            <source>Lines of many points become fewer lines and arcs within this; 0: they stay</source>
            <translation>Linhas de muitos pontos viram menos linhas e arcos dentro disto; 0: ficam</translation>
        </message>
        <message>
            <source>Lines that are marked with low power or lightly scribed before anything is cut</source>
            <translation>Linhas marcadas com pouca potência ou levemente riscadas antes de qualquer corte</translation>
        </message>
        <message>
            <source>Lines up to this long are left out</source>
            <translation>Linhas até este comprimento são deixadas de fora</translation>
        </message>
        <message>
            <source>Load {0}</source>
            <translation>Carregar {0}</translation>
        </message>
        <message>
            <source>Locking wheel</source>
            <translation>Roda de trava</translation>
        </message>
        <message>
            <source>Look at the findings, then decide.</source>
            <translation>Examine as ocorrências e decida.</translation>
        </message>
        <message>
            <source>Look at the machine, then connect again.</source>
            <translation>Examine a máquina e conecte de novo.</translation>
        </message>
        <message>
            <source>Look at the port, then connect again.</source>
            <translation>Examine a porta e conecte de novo.</translation>
        </message>
        <message>
            <source>Look-ahead</source>
            <translation>Antecipação (look-ahead)</translation>
        </message>
        <message>
            <source>Looking for a Python…</source>
            <translation>Procurando um Python…</translation>
        </message>
        <message>
            <source>Loop radius</source>
            <translation>Raio do laço</translation>
        </message>
        <message>
            <source>Loops</source>
            <translation>Laços</translation>
        </message>
        <message>
            <source>Loops above</source>
            <translation>Laços acima de</translation>
        </message>
        <message>
            <source>Loops in the scrap, which make outside corners sharp</source>
            <translation>Laços no retalho, que deixam vivos os cantos externos</translation>
        </message>
        <message>
            <source>Lower right to upper left</source>
            <translation>Inferior direito a superior esquerdo</translation>
        </message>
        <message>
            <source>Lowest speed</source>
            <translation>Rotação mínima</translation>
        </message>
        <message>
            <source>M6, by the machine</source>
            <translation>M6, pela máquina</translation>
        </message>
        <message>
            <source>MDF board</source>
            <translation>MDF</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>Máquina</translation>
        </message>
        <message>
            <source>Machine profile</source>
            <translation>Perfil da máquina</translation>
        </message>
        <message>
            <source>Machine test</source>
            <translation>Teste da máquina</translation>
        </message>
        <message>
            <source>Machines</source>
            <translation>Máquinas</translation>
        </message>
        <message>
            <source>Made from</source>
            <translation>Feito a partir de</translation>
        </message>
        <message>
            <source>Made of</source>
            <translation>Feita de</translation>
        </message>
        <message>
            <source>Major</source>
            <translation>Maior</translation>
        </message>
        <message>
            <source>Make a job first, with New job</source>
            <translation>Crie antes um trabalho, com Novo trabalho</translation>
        </message>
        <message>
            <source>Make shorter…</source>
            <translation>Encurtar…</translation>
        </message>
        <message>
            <source>Make this position the work zero of the axis.</source>
            <translation>Faz desta posição o zero-peça do eixo.</translation>
        </message>
        <message>
            <source>Margin</source>
            <translation>Margem</translation>
        </message>
        <message>
            <source>Margin around the motor</source>
            <translation>Margem em torno do motor</translation>
        </message>
        <message>
            <source>Marking feed</source>
            <translation>Avanço de marcação</translation>
        </message>
        <message>
            <source>Marking power</source>
            <translation>Potência de marcação</translation>
        </message>
        <message>
            <source>Marks</source>
            <translation>Marcações</translation>
        </message>
        <message>
            <source>Material</source>
            <translation>Material</translation>
        </message>
        <message>
            <source>Material of the cutter</source>
            <translation>De que a ferramenta é feita</translation>
        </message>
        <message>
            <source>Material that a round tool leaves at the ends of the long axis</source>
            <translation>O que a ferramenta redonda deixa nas pontas do eixo maior</translation>
        </message>
        <message>
            <source>Measured</source>
            <translation>Medido</translation>
        </message>
        <message>
            <source>Mend</source>
            <translation>Reparar</translation>
        </message>
        <message>
            <source>Message</source>
            <translation>Mensagem</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>Mensagens</translation>
        </message>
        <message>
            <source>Method</source>
            <translation>Método</translation>
        </message>
        <message>
            <source>Microsteps</source>
            <translation>Micropassos</translation>
        </message>
        <message>
            <source>Milling</source>
            <translation>Fresamento</translation>
        </message>
        <message>
            <source>Minor</source>
            <translation>Menor</translation>
        </message>
        <message>
            <source>Mirror…</source>
            <translation>Espelhar…</translation>
        </message>
        <message>
            <source>Mist</source>
            <translation>Névoa</translation>
        </message>
        <message>
            <source>Motion in air</source>
            <translation>Movimento no ar</translation>
        </message>
        <message>
            <source>Motor (its torque is checked)</source>
            <translation>Motor (o torque é verificado)</translation>
        </message>
        <message>
            <source>Motor angle</source>
            <translation>Ângulo do motor</translation>
        </message>
        <message>
            <source>Motor of a null pulse</source>
            <translation>Motor do pulso nulo</translation>
        </message>
        <message>
            <source>Motor speed</source>
            <translation>Rotação do motor</translation>
        </message>
        <message>
            <source>Motor steps: {0}</source>
            <translation>Passos dos motores: {0}</translation>
        </message>
        <message>
            <source>Motor's power</source>
            <translation>Potência do motor</translation>
        </message>
        <message>
            <source>Motor's steps</source>
            <translation>Passos do motor</translation>
        </message>
        <message>
            <source>Motors</source>
            <translation>Motores</translation>
        </message>
        <message>
            <source>Mounting plate</source>
            <translation>Chapa de montagem</translation>
        </message>
        <message>
            <source>Move</source>
            <translation>Movimento</translation>
        </message>
        <message>
            <source>Move a point</source>
            <translation>Mover um ponto</translation>
        </message>
        <message>
            <source>Move for as long as an arrow is held down; letting go stops.</source>
            <translation>Move enquanto uma seta estiver pressionada; soltar para o movimento.</translation>
        </message>
        <message>
            <source>Move operations</source>
            <translation>Mover operações</translation>
        </message>
        <message>
            <source>Move the machine in this direction.</source>
            <translation>Move a máquina neste sentido.</translation>
        </message>
        <message>
            <source>Moved by</source>
            <translation>Acionado por</translation>
        </message>
        <message>
            <source>Moved mass</source>
            <translation>Massa movida</translation>
        </message>
        <message>
            <source>Moves, scales, turns or rewrites the whole program</source>
            <translation>Move, escala, gira ou reescreve o programa inteiro</translation>
        </message>
        <message>
            <source>Move…</source>
            <translation>Mover…</translation>
        </message>
        <message>
            <source>NEMA motor plate</source>
            <translation>Chapa para motor NEMA</translation>
        </message>
        <message>
            <source>NEMA size</source>
            <translation>Tamanho NEMA</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Nome</translation>
        </message>
        <message>
            <source>Name of the profile: letters of a to z, digits, - and _</source>
            <translation>Nome do perfil: letras de a a z, algarismos, - e _</translation>
        </message>
        <message>
            <source>Narrow arcs</source>
            <translation>Arcos estreitos</translation>
        </message>
        <message>
            <source>Never farther off than, mm</source>
            <translation>Nunca mais longe que, mm</translation>
        </message>
        <message>
            <source>New job</source>
            <translation>Novo trabalho</translation>
        </message>
        <message>
            <source>New machine</source>
            <translation>Nova máquina</translation>
        </message>
        <message>
            <source>New program</source>
            <translation>Programa novo</translation>
        </message>
        <message>
            <source>New…</source>
            <translation>Nova…</translation>
        </message>
        <message>
            <source>Next</source>
            <translation>Próximo</translation>
        </message>
        <message>
            <source>Next, in the controller's panel: connect, work zero, start.</source>
            <translation>Continua no painel do controlador: conectar, zero-peça, iniciar.</translation>
        </message>
        <message>
            <source>No connection</source>
            <translation>Sem conexão</translation>
        </message>
        <message>
            <source>No controller is connected.</source>
            <translation>Nenhum controlador está conectado.</translation>
        </message>
        <message>
            <source>No job is unfinished.</source>
            <translation>Nenhum trabalho está inacabado.</translation>
        </message>
        <message>
            <source>No job runs: there is no cut to go back along.</source>
            <translation>Nenhum trabalho está em execução: não há corte ao longo do qual voltar.</translation>
        </message>
        <message>
            <source>No messages yet</source>
            <translation>Nenhuma mensagem ainda</translation>
        </message>
        <message>
            <source>No place is chosen yet.</source>
            <translation>Nenhum lugar foi escolhido ainda.</translation>
        </message>
        <message>
            <source>Not certain</source>
            <translation>Incerto</translation>
        </message>
        <message>
            <source>Not connected</source>
            <translation>Desconectado</translation>
        </message>
        <message>
            <source>Not sent</source>
            <translation>Não enviado</translation>
        </message>
        <message>
            <source>Not used: {0}</source>
            <translation>Não usado: {0}</translation>
        </message>
        <message>
            <source>Notches</source>
            <translation>Entalhes</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>Observação</translation>
        </message>
        <message>
            <source>Nothing changes.</source>
            <translation>Nada muda.</translation>
        </message>
        <message>
            <source>Nothing moves that could be held.</source>
            <translation>Nada se move que possa ser pausado.</translation>
        </message>
        <message>
            <source>Nothing moves that could be stopped. The emergency stop is on the machine.</source>
            <translation>Nada se move que possa ser parado. A parada de emergência fica na máquina.</translation>
        </message>
        <message>
            <source>Nothing was found: the program can be sent.</source>
            <translation>Nada foi encontrado: o programa pode ser enviado.</translation>
        </message>
        <message>
            <source>Nozzle, lens, wire or blade; empty: the first of the chart for this thickness</source>
            <translation>Bico, lente, fio ou lâmina; vazio: o primeiro da tabela para esta espessura</translation>
        </message>
        <message>
            <source>Number</source>
            <translation>Número</translation>
        </message>
        <message>
            <source>Number the lines…</source>
            <translation>Numerar as linhas…</translation>
        </message>
        <message>
            <source>Objects</source>
            <translation>Objetos</translation>
        </message>
        <message>
            <source>Of a bull nose; 0: not given</source>
            <translation>De uma fresa toroidal; 0: não informado</translation>
        </message>
        <message>
            <source>Of its curves</source>
            <translation>De suas curvas</translation>
        </message>
        <message>
            <source>Of one wall that a jet or wire leaves, against the vertical; 0: none</source>
            <translation>De uma parede deixada pelo jato ou fio, em relação à vertical; 0: nenhuma</translation>
        </message>
        <message>
            <source>Of the arc</source>
            <translation>Do arco</translation>
        </message>
        <message>
            <source>Of the bores; 0: that of each circle of the drawing</source>
            <translation>Dos furos; 0: o de cada círculo do desenho</translation>
        </message>
        <message>
            <source>Of the capitals, or of the em</source>
            <translation>Das maiúsculas, ou do corpo da fonte</translation>
        </message>
        <message>
            <source>Of the corners seen from above; 0: as round as the tool</source>
            <translation>Dos cantos vistos de cima; 0: tão redondos quanto a ferramenta</translation>
        </message>
        <message>
            <source>Of the driver, in a full step</source>
            <translation>Do driver, em um passo inteiro</translation>
        </message>
        <message>
            <source>Of the font, such as Bold; empty: the regular one</source>
            <translation>Da fonte, como Bold; vazio: o normal</translation>
        </message>
        <message>
            <source>Of the grid about its first hole</source>
            <translation>Da grade em torno do seu primeiro furo</translation>
        </message>
        <message>
            <source>Of the pulley that drives the belt</source>
            <translation>Da polia que aciona a correia</translation>
        </message>
        <message>
            <source>Of the written program</source>
            <translation>Do programa gerado</translation>
        </message>
        <message>
            <source>Off</source>
            <translation>Desligada</translation>
        </message>
        <message>
            <source>On</source>
            <translation>Ligado</translation>
        </message>
        <message>
            <source>On its cut</source>
            <translation>Sobre o corte</translation>
        </message>
        <message>
            <source>On the path</source>
            <translation>No caminho</translation>
        </message>
        <message>
            <source>On which side of the cut the part lies, seen along it</source>
            <translation>De que lado do corte fica a peça, visto ao longo dele</translation>
        </message>
        <message>
            <source>On which side of the lines the tool runs</source>
            <translation>De que lado das linhas a ferramenta corre</translation>
        </message>
        <message>
            <source>One end of the diagonal, from the work zero</source>
            <translation>Uma ponta da diagonal, a partir do zero da peça</translation>
        </message>
        <message>
            <source>One hole at each point</source>
            <translation>Um furo em cada ponto</translation>
        </message>
        <message>
            <source>One step back</source>
            <translation>Um passo atrás</translation>
        </message>
        <message>
            <source>One step is</source>
            <translation>Um passo é</translation>
        </message>
        <message>
            <source>One step on</source>
            <translation>Um passo adiante</translation>
        </message>
        <message>
            <source>Open a G-code file</source>
            <translation>Abrir um arquivo G-code</translation>
        </message>
        <message>
            <source>Open contour</source>
            <translation>Contorno aberto</translation>
        </message>
        <message>
            <source>Open job</source>
            <translation>Abrir trabalho</translation>
        </message>
        <message>
            <source>Open or make a document first</source>
            <translation>Abra ou crie antes um documento</translation>
        </message>
        <message>
            <source>Open pulse letters</source>
            <translation>Abrir letras de pulso</translation>
        </message>
        <message>
            <source>Open the 3D view of the document first</source>
            <translation>Abra antes a vista 3D do documento</translation>
        </message>
        <message>
            <source>Open…</source>
            <translation>Abrir…</translation>
        </message>
        <message>
            <source>Operation</source>
            <translation>Operação</translation>
        </message>
        <message>
            <source>Operations</source>
            <translation>Operações</translation>
        </message>
        <message>
            <source>Order</source>
            <translation>Ordem</translation>
        </message>
        <message>
            <source>Other corner</source>
            <translation>Outro canto</translation>
        </message>
        <message>
            <source>Other diagonal (0: none)</source>
            <translation>Outra diagonal (0: nenhuma)</translation>
        </message>
        <message>
            <source>Outer diameter</source>
            <translation>Diâmetro externo</translation>
        </message>
        <message>
            <source>Outlines of the clamps</source>
            <translation>Contornos dos grampos</translation>
        </message>
        <message>
            <source>Outputs</source>
            <translation>Saídas</translation>
        </message>
        <message>
            <source>Outputs during a retract</source>
            <translation>Saídas na volta</translation>
        </message>
        <message>
            <source>Outputs that are on while cutting</source>
            <translation>O que fica ligado durante o corte</translation>
        </message>
        <message>
            <source>Outside corners that turn by more get a loop</source>
            <translation>Cantos externos que viram mais recebem um laço</translation>
        </message>
        <message>
            <source>Oval flange</source>
            <translation>Flange oval</translation>
        </message>
        <message>
            <source>Over-burn</source>
            <translation>Ultrapassagem</translation>
        </message>
        <message>
            <source>Overcut</source>
            <translation>Sobrecorte</translation>
        </message>
        <message>
            <source>Overhang</source>
            <translation>Passagem da borda</translation>
        </message>
        <message>
            <source>Overlap</source>
            <translation>Sobreposição</translation>
        </message>
        <message>
            <source>Overrides</source>
            <translation>Ajustes (override)</translation>
        </message>
        <message>
            <source>Overrides work only while the machine is idle or cutting.</source>
            <translation>Os ajustes só funcionam com a máquina pronta ou usinando.</translation>
        </message>
        <message>
            <source>Oxyfuel</source>
            <translation>Oxicorte</translation>
        </message>
        <message>
            <source>POM (acetal)</source>
            <translation>POM (acetal)</translation>
        </message>
        <message>
            <source>PVC foam board</source>
            <translation>PVC expandido</translation>
        </message>
        <message>
            <source>Pairs of letters stand as near as the font says</source>
            <translation>Pares de letras ficam tão próximos quanto a fonte diz</translation>
        </message>
        <message>
            <source>Parallel port</source>
            <translation>Porta paralela</translation>
        </message>
        <message>
            <source>Parallelogram</source>
            <translation>Paralelogramo</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Peças</translation>
        </message>
        <message>
            <source>Parts and signs</source>
            <translation>Peças e placas</translation>
        </message>
        <message>
            <source>Passes</source>
            <translation>Passes</translation>
        </message>
        <message>
            <source>Path</source>
            <translation>Trajetória</translation>
        </message>
        <message>
            <source>Pattern</source>
            <translation>Padrão</translation>
        </message>
        <message>
            <source>Pause</source>
            <translation>Pausa</translation>
        </message>
        <message>
            <source>Pause between pulses</source>
            <translation>Pausa entre pulsos</translation>
        </message>
        <message>
            <source>Pause of the wire where the path turns back; shorter at blunter corners</source>
            <translation>Quanto tempo o fio para onde o caminho volta; menos em cantos mais abertos</translation>
        </message>
        <message>
            <source>Paused</source>
            <translation>Em espera</translation>
        </message>
        <message>
            <source>Peck</source>
            <translation>Bicada</translation>
        </message>
        <message>
            <source>Picture</source>
            <translation>Imagem</translation>
        </message>
        <message>
            <source>Pierce delay</source>
            <translation>Espera na perfuração</translation>
        </message>
        <message>
            <source>Pierce distance</source>
            <translation>Distância da perfuração</translation>
        </message>
        <message>
            <source>Pierce height</source>
            <translation>Altura de perfuração</translation>
        </message>
        <message>
            <source>Pierces</source>
            <translation>Perfurações</translation>
        </message>
        <message>
            <source>Pin</source>
            <translation>Pino</translation>
        </message>
        <message>
            <source>Pin {0}: {1}</source>
            <translation>Pino {0}: {1}</translation>
        </message>
        <message>
            <source>Pins of the parallel port; a minus sign is active low</source>
            <translation>Pinos da porta paralela; o sinal de menos é ativo em nível baixo</translation>
        </message>
        <message>
            <source>Pitch</source>
            <translation>Passo</translation>
        </message>
        <message>
            <source>Pixels an inch; 0: as the file says</source>
            <translation>Pixels por polegada; 0: como o arquivo diz</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>Lugar</translation>
        </message>
        <message>
            <source>Place of the mirror, mm</source>
            <translation>Onde fica o espelho, mm</translation>
        </message>
        <message>
            <source>Places</source>
            <translation>Lugares</translation>
        </message>
        <message>
            <source>Plasma</source>
            <translation>Plasma</translation>
        </message>
        <message>
            <source>Play or pause</source>
            <translation>Reproduzir ou pausar</translation>
        </message>
        <message>
            <source>Please report it, with the details, at {0}</source>
            <translation>Relate-a, com os detalhes, em {0}</translation>
        </message>
        <message>
            <source>Plunge feed</source>
            <translation>Avanço de mergulho</translation>
        </message>
        <message>
            <source>Pocket</source>
            <translation>Bolsão</translation>
        </message>
        <message>
            <source>Point angle</source>
            <translation>Ângulo da broca</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Pontos</translation>
        </message>
        <message>
            <source>Points kept</source>
            <translation>Pontos mantidos</translation>
        </message>
        <message>
            <source>Points of the pull-out curve, rpm and Nm: 0 1.2; 300 1.0</source>
            <translation>Pontos da curva de torque, rpm e Nm: 0 1.2; 300 1.0</translation>
        </message>
        <message>
            <source>Polygons</source>
            <translation>Polígonos</translation>
        </message>
        <message>
            <source>Port</source>
            <translation>Porta</translation>
        </message>
        <message>
            <source>Port's address</source>
            <translation>Endereço da porta</translation>
        </message>
        <message>
            <source>Position</source>
            <translation>Posição</translation>
        </message>
        <message>
            <source>Power</source>
            <translation>Potência</translation>
        </message>
        <message>
            <source>Power (M3)</source>
            <translation>Potência (M3)</translation>
        </message>
        <message>
            <source>Power on before the tool moves; 0: that of the chart</source>
            <translation>Tempo ligado antes de a ferramenta se mover; 0: o da tabela</translation>
        </message>
        <message>
            <source>Power ramp</source>
            <translation>Rampa de potência</translation>
        </message>
        <message>
            <source>Preheat</source>
            <translation>Pré-aquecimento</translation>
        </message>
        <message>
            <source>Preset speeds</source>
            <translation>Rotações fixas</translation>
        </message>
        <message>
            <source>Preview</source>
            <translation>Prévia</translation>
        </message>
        <message>
            <source>Previous</source>
            <translation>Anterior</translation>
        </message>
        <message>
            <source>Price per hour</source>
            <translation>Preço por hora</translation>
        </message>
        <message>
            <source>Price per metre cut</source>
            <translation>Preço por metro cortado</translation>
        </message>
        <message>
            <source>Price per m² of material</source>
            <translation>Preço por m² de material</translation>
        </message>
        <message>
            <source>Price per pierce</source>
            <translation>Preço por perfuração</translation>
        </message>
        <message>
            <source>Price per sheet</source>
            <translation>Preço por chapa</translation>
        </message>
        <message>
            <source>Problem</source>
            <translation>Problema</translation>
        </message>
        <message>
            <source>Process</source>
            <translation>Processo</translation>
        </message>
        <message>
            <source>Processes</source>
            <translation>Processos</translation>
        </message>
        <message>
            <source>Profile</source>
            <translation>Perfil</translation>
        </message>
        <message>
            <source>Profiles (*.toml)</source>
            <translation>Perfis (*.toml)</translation>
        </message>
        <message>
            <source>Program</source>
            <translation>Programa</translation>
        </message>
        <message>
            <source>Program number</source>
            <translation>Número do programa</translation>
        </message>
        <message>
            <source>Program: {0}</source>
            <translation>Programa: {0}</translation>
        </message>
        <message>
            <source>Program: {0}, in the editor</source>
            <translation>Programa: {0}, no editor</translation>
        </message>
        <message>
            <source>Programs</source>
            <translation>Programas</translation>
        </message>
        <message>
            <source>Programs ({0})</source>
            <translation>Programas ({0})</translation>
        </message>
        <message>
            <source>Pulley's teeth</source>
            <translation>Dentes da polia</translation>
        </message>
        <message>
            <source>Pulse</source>
            <translation>Pulso</translation>
        </message>
        <message>
            <source>Pulse angle</source>
            <translation>Ângulo por pulso</translation>
        </message>
        <message>
            <source>Pulse letters</source>
            <translation>Letras de pulso</translation>
        </message>
        <message>
            <source>Pulse letters ({0})</source>
            <translation>Letras de pulso ({0})</translation>
        </message>
        <message>
            <source>Pulse letters: {0}</source>
            <translation>Letras de pulso: {0}</translation>
        </message>
        <message>
            <source>Pulse rate</source>
            <translation>Frequência</translation>
        </message>
        <message>
            <source>Pulse width</source>
            <translation>Largura do pulso</translation>
        </message>
        <message>
            <source>Pulses</source>
            <translation>Pulsos</translation>
        </message>
        <message>
            <source>Pulses +</source>
            <translation>Pulsos +</translation>
        </message>
        <message>
            <source>Pulses by hand</source>
            <translation>Pulsos à mão</translation>
        </message>
        <message>
            <source>Pulses of</source>
            <translation>Pulsos de</translation>
        </message>
        <message>
            <source>Pulses −</source>
            <translation>Pulsos −</translation>
        </message>
        <message>
            <source>Pulses/s</source>
            <translation>Pulsos/s</translation>
        </message>
        <message>
            <source>Put into the profile</source>
            <translation>Pôr no perfil</translation>
        </message>
        <message>
            <source>Put the stock around the selection, or around the drawings of the operations</source>
            <translation>Põe o bloco em torno do que está selecionado, ou dos desenhos das operações</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>Raio</translation>
        </message>
        <message>
            <source>Radius in</source>
            <translation>Raio entrada</translation>
        </message>
        <message>
            <source>Radius in pixels of a blur that takes out noise</source>
            <translation>Raio em pixels de um desfoque que tira o ruído</translation>
        </message>
        <message>
            <source>Radius of the inner corner</source>
            <translation>Raio do canto interno</translation>
        </message>
        <message>
            <source>Radius of the inner corners</source>
            <translation>Raio dos cantos internos</translation>
        </message>
        <message>
            <source>Radius out</source>
            <translation>Raio saída</translation>
        </message>
        <message>
            <source>Radius x</source>
            <translation>Semieixo x</translation>
        </message>
        <message>
            <source>Radius y</source>
            <translation>Semieixo y</translation>
        </message>
        <message>
            <source>Ramp</source>
            <translation>Rampa</translation>
        </message>
        <message>
            <source>Ramp begin</source>
            <translation>Início da rampa</translation>
        </message>
        <message>
            <source>Ramp length</source>
            <translation>Comprimento da rampa</translation>
        </message>
        <message>
            <source>Ramps</source>
            <translation>Rampas</translation>
        </message>
        <message>
            <source>Rapid</source>
            <translation>Rápido</translation>
        </message>
        <message>
            <source>Rapid speed</source>
            <translation>Velocidade rápida</translation>
        </message>
        <message>
            <source>Rapids</source>
            <translation>Rápidos</translation>
        </message>
        <message>
            <source>Ratchet wheel</source>
            <translation>Roda de catraca</translation>
        </message>
        <message>
            <source>Reached</source>
            <translation>Alcançado</translation>
        </message>
        <message>
            <source>Read</source>
            <translation>Lido</translation>
        </message>
        <message>
            <source>Read the file again; operations keep their contours</source>
            <translation>Lê o arquivo de novo; as operações mantêm seus contornos</translation>
        </message>
        <message>
            <source>Reading the drawing: {0} %</source>
            <translation>Lendo o desenho: {0} %</translation>
        </message>
        <message>
            <source>Reading the drawing…</source>
            <translation>Lendo o desenho…</translation>
        </message>
        <message>
            <source>Reading the job…</source>
            <translation>Lendo o trabalho…</translation>
        </message>
        <message>
            <source>Reading the program back…</source>
            <translation>Relendo o programa…</translation>
        </message>
        <message>
            <source>Reading the program…</source>
            <translation>Lendo o programa…</translation>
        </message>
        <message>
            <source>Rectangle</source>
            <translation>Retângulo</translation>
        </message>
        <message>
            <source>Rectangular pocket</source>
            <translation>Bolsão retangular</translation>
        </message>
        <message>
            <source>Refused</source>
            <translation>Recusado</translation>
        </message>
        <message>
            <source>Refused by the machine</source>
            <translation>Recusado pela máquina</translation>
        </message>
        <message>
            <source>Region</source>
            <translation>Região</translation>
        </message>
        <message>
            <source>Regular polygon</source>
            <translation>Polígono regular</translation>
        </message>
        <message>
            <source>Relays</source>
            <translation>Relés</translation>
        </message>
        <message>
            <source>Relays and inputs</source>
            <translation>Relés e entradas</translation>
        </message>
        <message>
            <source>Relays are switched by hand only while the machine is idle.</source>
            <translation>Os relés só são ligados à mão com a máquina parada.</translation>
        </message>
        <message>
            <source>Release to close the line. Esc: give up this line.</source>
            <translation>Solte para fechar a linha. Esc: desistir desta linha.</translation>
        </message>
        <message>
            <source>Release: done. Release at the start: close the line. Shift: straight. Esc: give up this line.</source>
            <translation>Soltar: pronto. Soltar no início: fechar a linha. Shift: reta. Esc: desistir desta linha.</translation>
        </message>
        <message>
            <source>Reload</source>
            <translation>Recarregar</translation>
        </message>
        <message>
            <source>Reload {0}</source>
            <translation>Recarregar {0}</translation>
        </message>
        <message>
            <source>Remaining</source>
            <translation>Restante</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Remover</translation>
        </message>
        <message>
            <source>Remove tool</source>
            <translation>Remover</translation>
        </message>
        <message>
            <source>Removed</source>
            <translation>Removido</translation>
        </message>
        <message>
            <source>Repair</source>
            <translation>Reparo</translation>
        </message>
        <message>
            <source>Repair what is wrong, as far as the values under Repair allow</source>
            <translation>Repara o que está errado, até onde os valores em Reparo permitem</translation>
        </message>
        <message>
            <source>Repair what is wrong, as far as these values allow</source>
            <translation>Repara o que está errado, até onde estes valores permitem</translation>
        </message>
        <message>
            <source>Replace</source>
            <translation>Substituir</translation>
        </message>
        <message>
            <source>Replace with</source>
            <translation>Substituir por</translation>
        </message>
        <message>
            <source>Report</source>
            <translation>Relatório</translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation>Resolução</translation>
        </message>
        <message>
            <source>Rest at most</source>
            <translation>Resto máximo</translation>
        </message>
        <message>
            <source>Rest corners</source>
            <translation>Cantos com resto</translation>
        </message>
        <message>
            <source>Restart</source>
            <translation>Reinício</translation>
        </message>
        <message>
            <source>Restart from here…</source>
            <translation>Reiniciar daqui…</translation>
        </message>
        <message>
            <source>Restart the program at a line, an operation, a contour or a place in the picture.</source>
            <translation>Continua o programa a partir de uma linha, uma operação, um contorno ou um lugar na vista.</translation>
        </message>
        <message>
            <source>Restart the program at the present line; everything before it counts as cut</source>
            <translation>Continua o programa a partir da linha em andamento, tendo tudo antes dela como cortado</translation>
        </message>
        <message>
            <source>Restart: {0}</source>
            <translation>Reinício: {0}</translation>
        </message>
        <message>
            <source>Restart…</source>
            <translation>Reiniciar…</translation>
        </message>
        <message>
            <source>Result</source>
            <translation>Resultado</translation>
        </message>
        <message>
            <source>Resume</source>
            <translation>Retomar</translation>
        </message>
        <message>
            <source>Resume after a hold, a pause or the door.</source>
            <translation>Continua após uma pausa, uma espera ou a porta.</translation>
        </message>
        <message>
            <source>Retract</source>
            <translation>Retração</translation>
        </message>
        <message>
            <source>Retract to</source>
            <translation>Recuar até</translation>
        </message>
        <message>
            <source>Reverse (M4)</source>
            <translation>Reverso (M4)</translation>
        </message>
        <message>
            <source>Reverse the contours</source>
            <translation>Inverter os contornos</translation>
        </message>
        <message>
            <source>Revert</source>
            <translation>Reverter</translation>
        </message>
        <message>
            <source>Ring</source>
            <translation>Anel</translation>
        </message>
        <message>
            <source>Ring sector</source>
            <translation>Setor de anel</translation>
        </message>
        <message>
            <source>Rotate…</source>
            <translation>Girar…</translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation>Rotação</translation>
        </message>
        <message>
            <source>Round shapes</source>
            <translation>Formas redondas</translation>
        </message>
        <message>
            <source>Rows</source>
            <translation>Linhas</translation>
        </message>
        <message>
            <source>Rules</source>
            <translation>Regras</translation>
        </message>
        <message>
            <source>Running</source>
            <translation>Usinando</translation>
        </message>
        <message>
            <source>S is the speed at the surface</source>
            <translation>S é a velocidade na superfície</translation>
        </message>
        <message>
            <source>S is turns per minute</source>
            <translation>S são rotações por minuto</translation>
        </message>
        <message>
            <source>S-curve</source>
            <translation>Curva S</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>Salvar</translation>
        </message>
        <message>
            <source>Save and go on</source>
            <translation>Salvar e continuar</translation>
        </message>
        <message>
            <source>Save as…</source>
            <translation>Salvar como…</translation>
        </message>
        <message>
            <source>Save program as…</source>
            <translation>Salvar programa como…</translation>
        </message>
        <message>
            <source>Saved {0}</source>
            <translation>{0} salvo</translation>
        </message>
        <message>
            <source>Scale…</source>
            <translation>Escalar…</translation>
        </message>
        <message>
            <source>Screw</source>
            <translation>Fuso</translation>
        </message>
        <message>
            <source>Screw speed</source>
            <translation>Rotação do fuso</translation>
        </message>
        <message>
            <source>Screw's pitch</source>
            <translation>Passo do fuso</translation>
        </message>
        <message>
            <source>Scribe</source>
            <translation>Riscador</translation>
        </message>
        <message>
            <source>Second eye</source>
            <translation>Segundo olhal</translation>
        </message>
        <message>
            <source>Second hole</source>
            <translation>Segundo furo</translation>
        </message>
        <message>
            <source>Seconds at the bottom</source>
            <translation>Segundos no fundo</translation>
        </message>
        <message>
            <source>Sector</source>
            <translation>Setor</translation>
        </message>
        <message>
            <source>Segment</source>
            <translation>Segmento</translation>
        </message>
        <message>
            <source>Select a drawing in the tree or in the 3D view first</source>
            <translation>Selecione antes um desenho na árvore ou na vista 3D</translation>
        </message>
        <message>
            <source>Select a drawing or a solid first</source>
            <translation>Selecione antes um desenho ou um sólido</translation>
        </message>
        <message>
            <source>Select one or more operations in the tree</source>
            <translation>Selecione uma ou mais operações na árvore</translation>
        </message>
        <message>
            <source>Select one or more solids first</source>
            <translation>Selecione antes um ou mais sólidos</translation>
        </message>
        <message>
            <source>Select operations of one job</source>
            <translation>Selecione operações de um só trabalho</translation>
        </message>
        <message>
            <source>Select the area to clear: a sketch, closed wires, or faces of a solid</source>
            <translation>Selecione o que esvaziar: um esboço, fios fechados ou faces de um sólido</translation>
        </message>
        <message>
            <source>Select the job in the tree: this document has several</source>
            <translation>Selecione o trabalho na árvore: este documento tem vários</translation>
        </message>
        <message>
            <source>Select the lines to cut: a sketch, wires, or faces or edges of a solid</source>
            <translation>Selecione o que recortar: um esboço, fios, ou faces ou arestas de um sólido</translation>
        </message>
        <message>
            <source>Select the lines to engrave: a sketch, a wire, a B-spline or a freehand line</source>
            <translation>Selecione o que será gravado: um esboço, um arame, uma B-spline ou uma linha à mão livre</translation>
        </message>
        <message>
            <source>Send</source>
            <translation>Enviar</translation>
        </message>
        <message>
            <source>Send a G-code file…</source>
            <translation>Enviar um arquivo de G-code…</translation>
        </message>
        <message>
            <source>Send anyway</source>
            <translation>Enviar assim mesmo</translation>
        </message>
        <message>
            <source>Send this restart…</source>
            <translation>Enviar este reinício…</translation>
        </message>
        <message>
            <source>Send time</source>
            <translation>Tempo de envio</translation>
        </message>
        <message>
            <source>Sent ahead at most</source>
            <translation>Enviado à frente no máximo</translation>
        </message>
        <message>
            <source>Setting</source>
            <translation>Composição</translation>
        </message>
        <message>
            <source>Shape</source>
            <translation>Forma</translation>
        </message>
        <message>
            <source>Shape of the raw material</source>
            <translation>Como é a matéria-prima</translation>
        </message>
        <message>
            <source>Shapes</source>
            <translation>Formas</translation>
        </message>
        <message>
            <source>Sheet cut</source>
            <translation>Corte de chapa</translation>
        </message>
        <message>
            <source>Sheet, X</source>
            <translation>Chapa, X</translation>
        </message>
        <message>
            <source>Sheet, Y</source>
            <translation>Chapa, Y</translation>
        </message>
        <message>
            <source>Shield</source>
            <translation>Escudo</translation>
        </message>
        <message>
            <source>Shorter than</source>
            <translation>Mais curtos que</translation>
        </message>
        <message>
            <source>Show how far the last unfinished job came, and restart it there.</source>
            <translation>Diz até onde chegou o último trabalho que não foi cortado até o fim, e o reinicia ali.</translation>
        </message>
        <message>
            <source>Show the tool's path</source>
            <translation>Mostra a trajetória da ferramenta</translation>
        </message>
        <message>
            <source>Shows the same program as this machine's controller reads it: M6 becomes the machine's tool change</source>
            <translation>Mostra o mesmo programa como o controlador desta máquina o lê: M6 vira a troca de ferramenta da máquina</translation>
        </message>
        <message>
            <source>Side</source>
            <translation>Lado</translation>
        </message>
        <message>
            <source>Side along X</source>
            <translation>Lado em X</translation>
        </message>
        <message>
            <source>Side along Y</source>
            <translation>Lado em Y</translation>
        </message>
        <message>
            <source>Sides</source>
            <translation>Lados</translation>
        </message>
        <message>
            <source>Signals and pins</source>
            <translation>Sinais e pinos</translation>
        </message>
        <message>
            <source>Simplified</source>
            <translation>Simplificado</translation>
        </message>
        <message>
            <source>Simplify</source>
            <translation>Simplificar</translation>
        </message>
        <message>
            <source>Simulate again</source>
            <translation>Simular de novo</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Tamanho</translation>
        </message>
        <message>
            <source>Size of square and circle</source>
            <translation>Tamanho do quadrado e do círculo</translation>
        </message>
        <message>
            <source>Slant</source>
            <translation>Inclinação</translation>
        </message>
        <message>
            <source>Slot</source>
            <translation>Rasgo</translation>
        </message>
        <message>
            <source>Slots and holes</source>
            <translation>Rasgos e furos</translation>
        </message>
        <message>
            <source>Slower than published</source>
            <translation>Mais lento que o publicado</translation>
        </message>
        <message>
            <source>Small holes</source>
            <translation>Furos pequenos</translation>
        </message>
        <message>
            <source>Small holes at a feed of their own</source>
            <translation>Furos pequenos com avanço próprio</translation>
        </message>
        <message>
            <source>Smaller areas, in mm², are left out; 0: four pixels</source>
            <translation>Áreas menores, em mm², são deixadas de fora; 0: quatro pixels</translation>
        </message>
        <message>
            <source>Smooth</source>
            <translation>Suavizar</translation>
        </message>
        <message>
            <source>Solids that hold the work down, which the tool must not touch</source>
            <translation>Sólidos que prendem a peça e em que a ferramenta não pode tocar</translation>
        </message>
        <message>
            <source>Solids that the tool must not touch; findings name them by their number</source>
            <translation>Sólidos em que a ferramenta não pode tocar; as ocorrências os citam pelo número</translation>
        </message>
        <message>
            <source>Sounds</source>
            <translation>Sons</translation>
        </message>
        <message>
            <source>Spacing</source>
            <translation>Espaçamento</translation>
        </message>
        <message>
            <source>Specks</source>
            <translation>Manchas</translation>
        </message>
        <message>
            <source>Speed</source>
            <translation>Velocidade</translation>
        </message>
        <message>
            <source>Spin-up time</source>
            <translation>Tempo até a rotação</translation>
        </message>
        <message>
            <source>Spindle</source>
            <translation>Spindle</translation>
        </message>
        <message>
            <source>Spindle and relays</source>
            <translation>Fuso e relés</translation>
        </message>
        <message>
            <source>Spindle turns a minute; 0: those of the job's material</source>
            <translation>Rotações do spindle por minuto; 0: as do material do trabalho</translation>
        </message>
        <message>
            <source>Spot holes below</source>
            <translation>Marca furos abaixo de</translation>
        </message>
        <message>
            <source>Spot time</source>
            <translation>Tempo do ponto</translation>
        </message>
        <message>
            <source>Square</source>
            <translation>Quadrado</translation>
        </message>
        <message>
            <source>Square flange</source>
            <translation>Flange quadrado</translation>
        </message>
        <message>
            <source>Squareness</source>
            <translation>Esquadro</translation>
        </message>
        <message>
            <source>Star</source>
            <translation>Estrela</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Iniciar</translation>
        </message>
        <message>
            <source>Start angle</source>
            <translation>Ângulo inicial</translation>
        </message>
        <message>
            <source>Start/stop wait</source>
            <translation>Espera de partida/parada</translation>
        </message>
        <message>
            <source>Starting</source>
            <translation>Iniciando</translation>
        </message>
        <message>
            <source>State</source>
            <translation>Estado</translation>
        </message>
        <message>
            <source>Steepest ramp</source>
            <translation>Rampa máxima</translation>
        </message>
        <message>
            <source>Step ({0})</source>
            <translation>Passo ({0})</translation>
        </message>
        <message>
            <source>Step times</source>
            <translation>Tempos de passo</translation>
        </message>
        <message>
            <source>Step {0} of {1}</source>
            <translation>Etapa {0} de {1}</translation>
        </message>
        <message>
            <source>Stepdown ap</source>
            <translation>Profundidade de corte ap</translation>
        </message>
        <message>
            <source>Stepover ae</source>
            <translation>Penetração de trabalho ae</translation>
        </message>
        <message>
            <source>Stepper motor (open loop)</source>
            <translation>Motor de passo (malha aberta)</translation>
        </message>
        <message>
            <source>Steps of the ramp</source>
            <translation>Passos da rampa</translation>
        </message>
        <message>
            <source>Steps per mm</source>
            <translation>Passos por mm</translation>
        </message>
        <message>
            <source>Steps/mm</source>
            <translation>Passos/mm</translation>
        </message>
        <message>
            <source>Stock</source>
            <translation>Bloco</translation>
        </message>
        <message>
            <source>Stock to leave</source>
            <translation>Sobremetal</translation>
        </message>
        <message>
            <source>Stock to leave at the wall for another operation</source>
            <translation>O que fica na parede para outra operação tirar</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Parar</translation>
        </message>
        <message>
            <source>Stop the cut and close</source>
            <translation>Parar o corte e fechar</translation>
        </message>
        <message>
            <source>Stop: slow down, stop, spindle off; the rest of the job is not cut. This is not an emergency stop: the emergency stop is on the machine.</source>
            <translation>Parar: desacelera, para e desliga o spindle; o resto do trabalho não é usinado. Isto não é uma parada de emergência: a parada de emergência fica na máquina.</translation>
        </message>
        <message>
            <source>Stopped</source>
            <translation>Parado</translation>
        </message>
        <message>
            <source>Stopping…</source>
            <translation>Parando…</translation>
        </message>
        <message>
            <source>Style</source>
            <translation>Estilo</translation>
        </message>
        <message>
            <source>Sweep</source>
            <translation>Abertura</translation>
        </message>
        <message>
            <source>Switch it on or off.</source>
            <translation>Ligar ou desligar.</translation>
        </message>
        <message>
            <source>Switch {0}</source>
            <translation>Alternar {0}</translation>
        </message>
        <message>
            <source>S{0} clockwise</source>
            <translation>S{0} horário</translation>
        </message>
        <message>
            <source>S{0} counter-clockwise</source>
            <translation>S{0} anti-horário</translation>
        </message>
        <message>
            <source>T-bracket</source>
            <translation>Suporte em T</translation>
        </message>
        <message>
            <source>T-slot</source>
            <translation>Rasgo em T</translation>
        </message>
        <message>
            <source>Tabs</source>
            <translation>Pontes</translation>
        </message>
        <message>
            <source>Tag</source>
            <translation>Etiqueta</translation>
        </message>
        <message>
            <source>Take into the program</source>
            <translation>Incluir no programa</translation>
        </message>
        <message>
            <source>Take out</source>
            <translation>Tirar</translation>
        </message>
        <message>
            <source>Take selected</source>
            <translation>Usar seleção</translation>
        </message>
        <message>
            <source>Take the chart's value again</source>
            <translation>Voltar ao valor da tabela</translation>
        </message>
        <message>
            <source>Take the dial's reading from both sides first.</source>
            <translation>Faça primeiro a leitura do relógio dos dois lados.</translation>
        </message>
        <message>
            <source>Take the line numbers out</source>
            <translation>Tirar os números de linha</translation>
        </message>
        <message>
            <source>Take the reading</source>
            <translation>Registrar a leitura</translation>
        </message>
        <message>
            <source>Take the solids that are selected for clamps</source>
            <translation>Usa como grampos os sólidos selecionados</translation>
        </message>
        <message>
            <source>Taken out, drawn twice</source>
            <translation>Retirado, desenhado duas vezes</translation>
        </message>
        <message>
            <source>Taken out, tiny</source>
            <translation>Retirado, minúsculo</translation>
        </message>
        <message>
            <source>Taper</source>
            <translation>Conicidade</translation>
        </message>
        <message>
            <source>Teeth</source>
            <translation>Dentes</translation>
        </message>
        <message>
            <source>Text</source>
            <translation>Texto</translation>
        </message>
        <message>
            <source>The G-code file that it is, which has nothing to do with the operations of its job</source>
            <translation>O arquivo de G-code que ele é, sem relação com as operações do seu trabalho</translation>
        </message>
        <message>
            <source>The T word of the program</source>
            <translation>A palavra T do programa</translation>
        </message>
        <message>
            <source>The angle between X and Y is {0:.4f}°: {1:.3f} mm over a metre.</source>
            <translation>O ângulo entre X e Y é {0:.4f}°: {1:.3f} mm em um metro.</translation>
        </message>
        <message>
            <source>The axis of each motor in order; -y is mounted the other way round: x y -y z</source>
            <translation>O eixo de cada motor em ordem; -y é um montado ao contrário: x y -y z</translation>
        </message>
        <message>
            <source>The baud rate of the serial port</source>
            <translation>A taxa de transmissão (baud) da porta serial</translation>
        </message>
        <message>
            <source>The centre, from the work zero</source>
            <translation>O centro, a partir do zero-peça</translation>
        </message>
        <message>
            <source>The checks found errors: nothing is sent. Mend them, then send again.</source>
            <translation>A verificação encontrou erros: nada foi enviado. Corrija-os e envie de novo.</translation>
        </message>
        <message>
            <source>The checks found errors: this restart must not be sent.</source>
            <translation>A verificação encontrou erros: este reinício não pode ser enviado.</translation>
        </message>
        <message>
            <source>The circles and points of sketches, or the circular edges of solids</source>
            <translation>Os círculos e pontos de esboços, ou as arestas circulares de sólidos</translation>
        </message>
        <message>
            <source>The clamps seen from above, at the height of their tops</source>
            <translation>Os grampos vistos de cima, na altura dos seus topos</translation>
        </message>
        <message>
            <source>The colour in the file</source>
            <translation>A cor no arquivo</translation>
        </message>
        <message>
            <source>The connection is being made.</source>
            <translation>A conexão está sendo feita.</translation>
        </message>
        <message>
            <source>The connection was lost during the test.</source>
            <translation>A conexão foi perdida durante o teste.</translation>
        </message>
        <message>
            <source>The controller does something that was not asked for here.</source>
            <translation>O controlador faz algo que não foi pedido aqui.</translation>
        </message>
        <message>
            <source>The controller is set up differently. Nothing was sent.</source>
            <translation>O controlador está configurado de outro modo. Nada foi enviado.</translation>
        </message>
        <message>
            <source>The controller's panel is attached again to a machine that was left connected.</source>
            <translation>O painel do controlador foi religado a uma máquina que ficou conectada.</translation>
        </message>
        <message>
            <source>The controller's settings are compared.</source>
            <translation>As configurações do controlador são comparadas.</translation>
        </message>
        <message>
            <source>The corner where the grid begins, from the work zero</source>
            <translation>O canto onde a grade começa, a partir do zero da peça</translation>
        </message>
        <message>
            <source>The current set at the power source; 0: from the chart</source>
            <translation>O que se ajusta na fonte; 0: a corrente da tabela</translation>
        </message>
        <message>
            <source>The cut chart gives this value; change it in the job</source>
            <translation>A tabela de corte dá este valor; altere-o no trabalho</translation>
        </message>
        <message>
            <source>The cut is simulated and checked.</source>
            <translation>O corte é simulado e verificado.</translation>
        </message>
        <message>
            <source>The depth below the top of the stock</source>
            <translation>A profundidade abaixo do topo do bloco</translation>
        </message>
        <message>
            <source>The depth of one pass at most, ap</source>
            <translation>A profundidade máxima de um passe, ap</translation>
        </message>
        <message>
            <source>The depth of one pass at most; 0: all at once</source>
            <translation>A profundidade máxima de um passe; 0: tudo de uma vez</translation>
        </message>
        <message>
            <source>The diameter at the other end of the flanks; 0: that of a metric thread</source>
            <translation>O diâmetro na outra ponta dos flancos; 0: o de uma rosca métrica</translation>
        </message>
        <message>
            <source>The diameter of the cutter</source>
            <translation>O diâmetro da fresa</translation>
        </message>
        <message>
            <source>The diameter of the tool holder; 0: not given</source>
            <translation>O diâmetro do que segura a ferramenta; 0: não informado</translation>
        </message>
        <message>
            <source>The document and the name of the object itself; a copy still has those of its original</source>
            <translation>O documento e o nome do próprio objeto; uma cópia ainda tem os do original</translation>
        </message>
        <message>
            <source>The drawing gives this value</source>
            <translation>O desenho define este valor</translation>
        </message>
        <message>
            <source>The drawing it followed, when that was deleted</source>
            <translation>O desenho que ela seguia, se foi excluído</translation>
        </message>
        <message>
            <source>The drawing that the objects follow</source>
            <translation>O desenho que os objetos seguem</translation>
        </message>
        <message>
            <source>The edge of the sheet at which the wire enters</source>
            <translation>A borda da chapa por onde o fio entra</translation>
        </message>
        <message>
            <source>The feed of a program without F, and the cutting speed of a language without F</source>
            <translation>O que vale num programa sem F, e a velocidade de corte de uma linguagem sem F</translation>
        </message>
        <message>
            <source>The feed of marks; 0: that of the cut</source>
            <translation>O avanço das marcações; 0: o do corte</translation>
        </message>
        <message>
            <source>The feed of the last pass at the wall; 0: the tool's own feed</source>
            <translation>O avanço do último passe na parede; 0: o avanço da própria ferramenta</translation>
        </message>
        <message>
            <source>The feed of the last pass; 0: the tool's own feed</source>
            <translation>O avanço do último passe; 0: o avanço da própria ferramenta</translation>
        </message>
        <message>
            <source>The feed of the program</source>
            <translation>O avanço do programa</translation>
        </message>
        <message>
            <source>The file has a new layout: its comments are not in it.</source>
            <translation>O arquivo tem nova disposição: os comentários não estão nele.</translation>
        </message>
        <message>
            <source>The file of a cut chart of your own; empty: the chart that ships</source>
            <translation>O arquivo de uma tabela de corte própria; vazio: a tabela que acompanha o programa</translation>
        </message>
        <message>
            <source>The fingerprint of the job's program from which this one was edited</source>
            <translation>A impressão digital do programa do trabalho a partir do qual este foi editado</translation>
        </message>
        <message>
            <source>The first line that is not certainly cut</source>
            <translation>A primeira linha que não está certamente cortada</translation>
        </message>
        <message>
            <source>The flat at the tip of a V-bit or engraver; 0: it is pointed</source>
            <translation>O plano na ponta de uma fresa em V ou de gravação; 0: ela é pontiaguda</translation>
        </message>
        <message>
            <source>The form of the cutter</source>
            <translation>A forma da fresa</translation>
        </message>
        <message>
            <source>The groups around it in the file</source>
            <translation>Os grupos em volta dele no arquivo</translation>
        </message>
        <message>
            <source>The height of the rapids between holes: G98 or G99</source>
            <translation>A altura dos rápidos entre furos: G98 ou G99</translation>
        </message>
        <message>
            <source>The job continues without FreeCAD; the controller's panel shows it when it is opened again.</source>
            <translation>O corte continua sem o FreeCAD; o painel do controlador o reencontra na próxima vez que for aberto.</translation>
        </message>
        <message>
            <source>The job is being cut.</source>
            <translation>O trabalho está sendo usinado.</translation>
        </message>
        <message>
            <source>The job that did not end</source>
            <translation>O trabalho que não terminou</translation>
        </message>
        <message>
            <source>The job waits on its cut. Resume cuts on from there.</source>
            <translation>O trabalho espera sobre o corte. Retomar continua o corte dali.</translation>
        </message>
        <message>
            <source>The job whose program is shown</source>
            <translation>O trabalho cujo programa é mostrado</translation>
        </message>
        <message>
            <source>The job with the machine, stock, tools and clamps for the program</source>
            <translation>O trabalho para cuja máquina, bloco, ferramentas e grampos o programa é feito</translation>
        </message>
        <message>
            <source>The last job of this machine, {0}, was not cut to its end. Unfinished job… shows how far it came.</source>
            <translation>O último trabalho desta máquina, {0}, não foi cortado até o fim. Trabalho inacabado… diz até onde ele chegou.</translation>
        </message>
        <message>
            <source>The last pass at the wall, ae_acab; 0: none</source>
            <translation>O último passe na parede, ae_acab; 0: nenhum</translation>
        </message>
        <message>
            <source>The last pass in depth, ap_acab; 0: none</source>
            <translation>O último passe em profundidade, ap_acab; 0: nenhum</translation>
        </message>
        <message>
            <source>The layer in the file</source>
            <translation>A camada no arquivo</translation>
        </message>
        <message>
            <source>The length of all cuts</source>
            <translation>O comprimento de todos os cortes</translation>
        </message>
        <message>
            <source>The length of all lines</source>
            <translation>O comprimento de todas as linhas</translation>
        </message>
        <message>
            <source>The length of the cutting edges; 0: not given</source>
            <translation>O comprimento das arestas de corte; 0: não informado</translation>
        </message>
        <message>
            <source>The length of the file's unit; 0: as the file says, or as its program usually means it</source>
            <translation>O comprimento da unidade do arquivo; 0: como o arquivo diz, ou como seu programa costuma querer dizer</translation>
        </message>
        <message>
            <source>The length of the lead's line</source>
            <translation>O comprimento da linha de entrada ou saída</translation>
        </message>
        <message>
            <source>The letters start at the machine's position.</source>
            <translation>As letras começam onde a máquina está.</translation>
        </message>
        <message>
            <source>The link to the controller is being started.</source>
            <translation>A ligação com o controlador está sendo iniciada.</translation>
        </message>
        <message>
            <source>The machine is at rest and waits.</source>
            <translation>A máquina está parada e à espera.</translation>
        </message>
        <message>
            <source>The machine is at rest; nothing is lost. Resume or stop.</source>
            <translation>A máquina está parada; nada se perdeu. Retome ou pare.</translation>
        </message>
        <message>
            <source>The machine is cutting a job.</source>
            <translation>A máquina está usinando um trabalho.</translation>
        </message>
        <message>
            <source>The machine is made free to jog while a job is held.</source>
            <translation>A máquina é liberada para o movimento manual enquanto um trabalho está parado.</translation>
        </message>
        <message>
            <source>The machine is moved by hand.</source>
            <translation>A máquina é movida manualmente.</translation>
        </message>
        <message>
            <source>The machine is not held: there is nothing to resume.</source>
            <translation>A máquina não está em pausa: não há o que retomar.</translation>
        </message>
        <message>
            <source>The machine is not in alarm: there is nothing to unlock.</source>
            <translation>A máquina não está em alarme: não há o que destravar.</translation>
        </message>
        <message>
            <source>The machine looks for its switches.</source>
            <translation>A máquina procura os fins de curso.</translation>
        </message>
        <message>
            <source>The machine must be idle: wait, or home or unlock it first.</source>
            <translation>A máquina precisa estar pronta: espere, ou antes referencie ou destrave-a.</translation>
        </message>
        <message>
            <source>The machine slows down, then the job is ended.</source>
            <translation>A máquina desacelera e o trabalho é encerrado.</translation>
        </message>
        <message>
            <source>The machine slows down.</source>
            <translation>A máquina desacelera.</translation>
        </message>
        <message>
            <source>The machine waits before each line of a job; Resume cuts the next one</source>
            <translation>A máquina espera antes de cada linha de um trabalho; Retomar corta a próxima</translation>
        </message>
        <message>
            <source>The machine with the dialect in which the program is read</source>
            <translation>A máquina em cujo dialeto o programa é lido</translation>
        </message>
        <message>
            <source>The machine's position is unknown: home it, or move the tool to the work zero and press All = 0.</source>
            <translation>A posição da máquina é desconhecida: referencie-a, ou leve a ferramenta ao zero-peça e pressione Todos = 0.</translation>
        </message>
        <message>
            <source>The machine's position is unknown: stop the job, then home the machine or set the zero of all axes.</source>
            <translation>A posição da máquina é desconhecida: pare o que ela fazia e depois referencie-a ou defina o zero de todos os eixos.</translation>
        </message>
        <message>
            <source>The marked solid is no clamp any more; it stays</source>
            <translation>O sólido marcado deixa de ser grampo; ele continua no documento</translation>
        </message>
        <message>
            <source>The middle of a mill's end that does not cut; 0: it cuts over its centre</source>
            <translation>O meio do topo da fresa que não corta; 0: ela tem corte no centro</translation>
        </message>
        <message>
            <source>The middle of the circle, from the work zero</source>
            <translation>O meio do círculo, a partir do zero da peça</translation>
        </message>
        <message>
            <source>The mini-lathe's link</source>
            <translation>A ligação do minitorno</translation>
        </message>
        <message>
            <source>The minor diameter that is cut</source>
            <translation>O diâmetro menor que é cortado</translation>
        </message>
        <message>
            <source>The name in the file</source>
            <translation>O nome no arquivo</translation>
        </message>
        <message>
            <source>The nominal diameter; 0: that of each circle of the drawing</source>
            <translation>O diâmetro nominal; 0: o de cada círculo do desenho</translation>
        </message>
        <message>
            <source>The operations, in their order</source>
            <translation>O que é usinado, nesta ordem</translation>
        </message>
        <message>
            <source>The order in which the holes are made</source>
            <translation>A ordem em que os furos são feitos</translation>
        </message>
        <message>
            <source>The order in which the lines are cut</source>
            <translation>A ordem em que as linhas são cortadas</translation>
        </message>
        <message>
            <source>The other end of the diagonal, before the rectangle is rotated</source>
            <translation>A outra ponta da diagonal, antes de o retângulo ser girado</translation>
        </message>
        <message>
            <source>The outline seen from above, or the faces or the section at a height</source>
            <translation>O contorno visto de cima, ou as faces ou a seção a uma altura</translation>
        </message>
        <message>
            <source>The parts and bodies that the clamps move with</source>
            <translation>As peças e os corpos com que os grampos se movem</translation>
        </message>
        <message>
            <source>The parts and bodies that the drawings move with</source>
            <translation>As peças e corpos com os quais os desenhos se movem</translation>
        </message>
        <message>
            <source>The path of the last job is read…</source>
            <translation>O caminho do último trabalho está sendo lido…</translation>
        </message>
        <message>
            <source>The place of the work zero in this document</source>
            <translation>Onde fica o zero-peça neste documento</translation>
        </message>
        <message>
            <source>The place of the work zero on the stock</source>
            <translation>Onde fica o zero-peça no bloco</translation>
        </message>
        <message>
            <source>The place on the cut is being looked for…</source>
            <translation>O lugar no corte está sendo procurado…</translation>
        </message>
        <message>
            <source>The places of the holes</source>
            <translation>Onde ficam os furos</translation>
        </message>
        <message>
            <source>The plunge feed of the program</source>
            <translation>O avanço de mergulho do programa</translation>
        </message>
        <message>
            <source>The points as they were drawn</source>
            <translation>Os pontos como foram desenhados</translation>
        </message>
        <message>
            <source>The position of the table is unknown: home the machine, or set the work zero again.</source>
            <translation>Não se sabe onde a mesa está: referencie a máquina ou defina de novo o zero-peça.</translation>
        </message>
        <message>
            <source>The profile has a value that is none: mend it first.</source>
            <translation>O perfil tem um valor inválido: corrija-o primeiro.</translation>
        </message>
        <message>
            <source>The profile of the machine at this port: its relays, and how it is driven</source>
            <translation>O perfil da máquina nesta porta: seus relés e como é acionada</translation>
        </message>
        <message>
            <source>The program has changed since: the view shows the earlier one.</source>
            <translation>O programa mudou desde então: o que se vê é o anterior.</translation>
        </message>
        <message>
            <source>The program has changed: it is read again.</source>
            <translation>O programa mudou: ele está sendo lido de novo.</translation>
        </message>
        <message>
            <source>The program is being checked with this work zero.</source>
            <translation>O programa está sendo verificado com este zero-peça.</translation>
        </message>
        <message>
            <source>The program is checked again, with the work zero that the machine has now.</source>
            <translation>O programa é verificado de novo, com o zero-peça que a máquina tem agora.</translation>
        </message>
        <message>
            <source>The program that is shown, checked and sent, if the machine needs one for each tool</source>
            <translation>Qual é mostrado, verificado e enviado, onde a máquina quer um por ferramenta</translation>
        </message>
        <message>
            <source>The program waits; Resume continues it.</source>
            <translation>O programa espera. Retomar continua.</translation>
        </message>
        <message>
            <source>The program's dialect; empty: the machine's own</source>
            <translation>O dialeto do programa; vazio: o da própria máquina</translation>
        </message>
        <message>
            <source>The program, kept in this document</source>
            <translation>O programa, guardado neste documento</translation>
        </message>
        <message>
            <source>The radius of loops at sharp outside corners</source>
            <translation>O raio dos laços em cantos externos vivos</translation>
        </message>
        <message>
            <source>The radius of the lead's arc</source>
            <translation>O raio do arco de entrada ou saída</translation>
        </message>
        <message>
            <source>The restart is made and proven…</source>
            <translation>O reinício está sendo criado e verificado…</translation>
        </message>
        <message>
            <source>The retract along the cut is being calculated: wait, hold or stop.</source>
            <translation>O caminho ao longo do corte está sendo determinado: espere, pause ou pare.</translation>
        </message>
        <message>
            <source>The retract along the cut is being checked…</source>
            <translation>O caminho ao longo do corte está sendo verificado…</translation>
        </message>
        <message>
            <source>The section of a beam, about the zero.</source>
            <translation>A seção de uma viga, em torno do zero.</translation>
        </message>
        <message>
            <source>The share of the feed there</source>
            <translation>A parte do avanço ali</translation>
        </message>
        <message>
            <source>The share of the feed there; a slower wire melts a wider kerf</source>
            <translation>A parte do avanço ali; um fio mais lento derrete um corte mais largo</translation>
        </message>
        <message>
            <source>The share of the feed with which they are cut</source>
            <translation>A parte do avanço com que são cortados</translation>
        </message>
        <message>
            <source>The share of the power at the pierce</source>
            <translation>A parte da potência na perfuração</translation>
        </message>
        <message>
            <source>The sketch, wire, B-spline or freehand line to follow</source>
            <translation>O esboço, arame, B-spline ou linha à mão livre a seguir</translation>
        </message>
        <message>
            <source>The sketch, wires or faces to cut: closed lines are parts and holes in turn</source>
            <translation>O esboço, arames ou faces cujas linhas são cortadas: as fechadas são alternadamente peças e furos</translation>
        </message>
        <message>
            <source>The sketch, wires or faces to follow</source>
            <translation>O esboço, fios ou faces cujas linhas são seguidas</translation>
        </message>
        <message>
            <source>The speed of cutting moves; 0: that of the job's material</source>
            <translation>A velocidade dos movimentos de corte; 0: a do material do trabalho</translation>
        </message>
        <message>
            <source>The speed of rapids, where the language leaves it to the machine</source>
            <translation>A velocidade dos rápidos, onde a linguagem a deixa para a máquina</translation>
        </message>
        <message>
            <source>The speed of the cut; 0: that of the chart</source>
            <translation>A velocidade do corte; 0: a da tabela</translation>
        </message>
        <message>
            <source>The speed straight down; 0: that of the job's material</source>
            <translation>A velocidade de descida reta; 0: a do material do trabalho</translation>
        </message>
        <message>
            <source>The speeds that a gear or a switch has, rising; none where any speed can be set</source>
            <translation>As rotações que uma engrenagem ou chave tem, crescentes; nenhuma onde qualquer rotação serve</translation>
        </message>
        <message>
            <source>The spindle's speed in the program</source>
            <translation>A rotação do spindle no programa</translation>
        </message>
        <message>
            <source>The step of the published method</source>
            <translation>O passo do método publicado</translation>
        </message>
        <message>
            <source>The test is under way: wait, or stop it.</source>
            <translation>O teste está em andamento: espere ou pare-o.</translation>
        </message>
        <message>
            <source>The thickest chip that a tooth bears; 0: not given</source>
            <translation>O cavaco mais espesso que um dente suporta; 0: não informado</translation>
        </message>
        <message>
            <source>The thickest material left in inner corners</source>
            <translation>O material mais grosso que fica em cantos internos</translation>
        </message>
        <message>
            <source>The thickest material left in them</source>
            <translation>O material mais grosso que fica neles</translation>
        </message>
        <message>
            <source>The thinnest chip of a tooth, below which it rubs; 0: not given</source>
            <translation>O cavaco mais fino de um dente, abaixo do qual ele só atrita; 0: não informado</translation>
        </message>
        <message>
            <source>The tool can retract along exactly the path by which it came.</source>
            <translation>A ferramenta pode voltar exatamente pelo caminho por onde veio.</translation>
        </message>
        <message>
            <source>The tool goes back along its cut while a job is cut, or is held.</source>
            <translation>A ferramenta volta ao longo do corte enquanto um trabalho é cortado ou está parado.</translation>
        </message>
        <message>
            <source>The tool goes forward again only after it went back.</source>
            <translation>A ferramenta só avança de novo depois de ter voltado.</translation>
        </message>
        <message>
            <source>The tool is at the end of the cut.</source>
            <translation>A ferramenta está onde o corte chegou.</translation>
        </message>
        <message>
            <source>The tool is on line {0}, at the end of the cut.</source>
            <translation>A ferramenta está na linha {0}, onde o corte chegou.</translation>
        </message>
        <message>
            <source>The tool is on line {0}, {1} behind the end of the cut.</source>
            <translation>A ferramenta está na linha {0}, {1} atrás de onde o corte chegou.</translation>
        </message>
        <message>
            <source>The tool moves along the cut.</source>
            <translation>A ferramenta se move ao longo do corte.</translation>
        </message>
        <message>
            <source>The tool that cuts it</source>
            <translation>A ferramenta que a executa</translation>
        </message>
        <message>
            <source>The tools that operations may choose from</source>
            <translation>As ferramentas que as operações podem escolher</translation>
        </message>
        <message>
            <source>The torch above the sheet while it cuts; 0: that of the chart</source>
            <translation>A tocha acima da chapa enquanto corta; 0: a altura da tabela</translation>
        </message>
        <message>
            <source>The torch above the sheet while it pierces; 0: that of the chart</source>
            <translation>A tocha acima da chapa enquanto perfura; 0: a altura da tabela</translation>
        </message>
        <message>
            <source>The waits between steps from rest, in ms, none longer than the one before it</source>
            <translation>As esperas entre passos a partir do repouso, em ms, nenhuma maior que a anterior</translation>
        </message>
        <message>
            <source>The width of one pass at most, ae</source>
            <translation>A largura máxima de um passe, ae</translation>
        </message>
        <message>
            <source>The width of the cut</source>
            <translation>A largura do corte</translation>
        </message>
        <message>
            <source>The width of the cut where it is not the chart's; 0: the chart's, else the tool's</source>
            <translation>A largura do corte quando não é a da tabela; 0: a da tabela, senão a da ferramenta</translation>
        </message>
        <message>
            <source>The width of the cut where it is not the tool's diameter; 0: the tool's own</source>
            <translation>A largura do corte onde não é o diâmetro da ferramenta; 0: a da própria ferramenta</translation>
        </message>
        <message>
            <source>The width of the cut; 0: that of the chart</source>
            <translation>A largura do corte; 0: a da tabela</translation>
        </message>
        <message>
            <source>The width of the cut; 0: that of the cut chart or the tool</source>
            <translation>A largura do corte; 0: a da tabela de corte ou da ferramenta</translation>
        </message>
        <message>
            <source>The width of the picture; 0: as its resolution says</source>
            <translation>A largura da imagem; 0: como sua resolução diz</translation>
        </message>
        <message>
            <source>The wire stays this close to every drawn point; 0 keeps every point that bends the line</source>
            <translation>O arame fica a no máximo esta distância de cada ponto desenhado; 0 mantém todos os pontos que curvam a linha</translation>
        </message>
        <message>
            <source>The work coordinate system</source>
            <translation>O sistema de coordenadas da peça</translation>
        </message>
        <message>
            <source>The work zero can be set only while the machine is idle.</source>
            <translation>O zero-peça só pode ser definido com a máquina pronta.</translation>
        </message>
        <message>
            <source>The working plane is seen from its edge: turn the view to draw on it.</source>
            <translation>O plano de trabalho é visto de lado: gire a vista para desenhar nele.</translation>
        </message>
        <message>
            <source>There is no restart to send yet.</source>
            <translation>Ainda não há reinício para enviar.</translation>
        </message>
        <message>
            <source>These profiles have changes that are not saved: {0}</source>
            <translation>Estes perfis têm mudanças não salvas: {0}</translation>
        </message>
        <message>
            <source>Thickness</source>
            <translation>Espessura</translation>
        </message>
        <message>
            <source>Thickness of the flanges</source>
            <translation>Espessura das mesas</translation>
        </message>
        <message>
            <source>Thickness of the web</source>
            <translation>Espessura da alma</translation>
        </message>
        <message>
            <source>This is cut by: {0}. The job's process is: {1}</source>
            <translation>Isto se corta por: {0}. O processo do trabalho é: {1}</translation>
        </message>
        <message>
            <source>This machine has no axis Z.</source>
            <translation>Esta máquina não tem o eixo Z.</translation>
        </message>
        <message>
            <source>This machine has no homing switches set up ($22=0).</source>
            <translation>Esta máquina não tem fins de curso de referência configurados ($22=0).</translation>
        </message>
        <message>
            <source>This needs a number without a unit, not '{0}'</source>
            <translation>Aqui vai um número sem unidade, não '{0}'</translation>
        </message>
        <message>
            <source>Thread</source>
            <translation>Rosquear</translation>
        </message>
        <message>
            <source>Threshold</source>
            <translation>Limiar</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Tempo</translation>
        </message>
        <message>
            <source>Time in the program</source>
            <translation>Tempo no programa</translation>
        </message>
        <message>
            <source>Time of the tool at rest with power; 0: from the cut chart</source>
            <translation>Quanto tempo a ferramenta fica parada com potência; 0: o da tabela de corte</translation>
        </message>
        <message>
            <source>Time that it is run</source>
            <translation>Vez em que é executada</translation>
        </message>
        <message>
            <source>Timing the moves…</source>
            <translation>Cronometrando os movimentos…</translation>
        </message>
        <message>
            <source>Tiny</source>
            <translation>Minúscula</translation>
        </message>
        <message>
            <source>Tiny contour</source>
            <translation>Contorno minúsculo</translation>
        </message>
        <message>
            <source>Tip</source>
            <translation>Ponta</translation>
        </message>
        <message>
            <source>Tip angle</source>
            <translation>Ângulo da ponta</translation>
        </message>
        <message>
            <source>Tip diameter</source>
            <translation>Diâmetro da ponta</translation>
        </message>
        <message>
            <source>To</source>
            <translation>Até</translation>
        </message>
        <message>
            <source>To install the missing packages, type in a terminal, with Python {0}, and start FreeCAD again:</source>
            <translation>Para obter o que falta, digite em um terminal, com Python {0}, e reinicie o FreeCAD:</translation>
        </message>
        <message>
            <source>To the begin</source>
            <translation>Ao início</translation>
        </message>
        <message>
            <source>To the end</source>
            <translation>Ao fim</translation>
        </message>
        <message>
            <source>To the entry</source>
            <translation>Até a entrada</translation>
        </message>
        <message>
            <source>To the line</source>
            <translation>Até a linha</translation>
        </message>
        <message>
            <source>To the start</source>
            <translation>Ao início</translation>
        </message>
        <message>
            <source>Tolerance</source>
            <translation>Tolerância</translation>
        </message>
        <message>
            <source>Tolerance of the cut line, which reduces the number of moves; 0: none</source>
            <translation>Quanto a linha cortada pode se afastar da desenhada para ter menos movimentos; 0: nada</translation>
        </message>
        <message>
            <source>Tool</source>
            <translation>Ferramenta</translation>
        </message>
        <message>
            <source>Tool change</source>
            <translation>Troca de ferramenta</translation>
        </message>
        <message>
            <source>Tool length</source>
            <translation>Comprimento da ferramenta</translation>
        </message>
        <message>
            <source>Tool tables in inches ({0})</source>
            <translation>Tabelas de ferramentas em polegadas ({0})</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Ferramentas</translation>
        </message>
        <message>
            <source>Tools ({0})</source>
            <translation>Ferramentas ({0})</translation>
        </message>
        <message>
            <source>Tools without feeds or speed use its table</source>
            <translation>Ferramentas sem avanço ou rotação tomam os da sua tabela</translation>
        </message>
        <message>
            <source>Toothed belt</source>
            <translation>Correia dentada</translation>
        </message>
        <message>
            <source>Top</source>
            <translation>Topo</translation>
        </message>
        <message>
            <source>Torch off before</source>
            <translation>Desliga antes</translation>
        </message>
        <message>
            <source>Torque at speed</source>
            <translation>Torque por rotação</translation>
        </message>
        <message>
            <source>Trace what is light instead of what is dark</source>
            <translation>Traça o que é claro em vez do que é escuro</translation>
        </message>
        <message>
            <source>Trapezoid</source>
            <translation>Trapézio</translation>
        </message>
        <message>
            <source>Travel</source>
            <translation>Curso</translation>
        </message>
        <message>
            <source>Travel for a turn of the screw; with several starts its lead</source>
            <translation>Percurso por volta do fuso; com várias entradas, o avanço da rosca</translation>
        </message>
        <message>
            <source>Travel from</source>
            <translation>Curso de</translation>
        </message>
        <message>
            <source>Travel of the motor at a reversal before the axis moves</source>
            <translation>O que o motor gira na inversão antes de o eixo se mover</translation>
        </message>
        <message>
            <source>Travel per turn</source>
            <translation>Avanço por volta</translation>
        </message>
        <message>
            <source>Travel to</source>
            <translation>Curso até</translation>
        </message>
        <message>
            <source>Triangular plate</source>
            <translation>Chapa triangular</translation>
        </message>
        <message>
            <source>Turns</source>
            <translation>Voltas</translation>
        </message>
        <message>
            <source>Turns of the encoder for one of screw or pulley</source>
            <translation>Voltas do encoder por volta do fuso ou da polia</translation>
        </message>
        <message>
            <source>Turns of the motor for one of screw or pulley</source>
            <translation>Voltas do motor por volta do fuso ou da polia</translation>
        </message>
        <message>
            <source>Twice from the middle to a side</source>
            <translation>Duas vezes do centro a um lado</translation>
        </message>
        <message>
            <source>Two eyes and the bar that joins them along X; the first eye's hole is at the zero.</source>
            <translation>Dois olhais e a barra que os une ao longo de X; o furo do primeiro olhal está no zero.</translation>
        </message>
        <message>
            <source>Two flanges that an offset web joins, its left lower corner at the zero; a hole in each flange.</source>
            <translation>Duas abas unidas por uma alma deslocada, o canto inferior esquerdo no zero; um furo em cada aba.</translation>
        </message>
        <message>
            <source>Two legs up from a base, the zero in the middle of the base's lower edge; a hole in each leg.</source>
            <translation>Duas abas acima de uma base, o zero no meio da borda inferior da base; um furo em cada aba.</translation>
        </message>
        <message>
            <source>Type a line: $$, $#, G0 X10</source>
            <translation>Digite uma linha: $$, $#, G0 X10</translation>
        </message>
        <message>
            <source>U-bracket</source>
            <translation>Suporte em U</translation>
        </message>
        <message>
            <source>Unfinished job…</source>
            <translation>Trabalho inacabado…</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Unidade</translation>
        </message>
        <message>
            <source>Units</source>
            <translation>Unidades</translation>
        </message>
        <message>
            <source>Unlock</source>
            <translation>Destravar</translation>
        </message>
        <message>
            <source>Unlock the alarm without homing: only if the position is certainly right.</source>
            <translation>Retira o alarme sem referenciar: só quando a posição está certa com certeza.</translation>
        </message>
        <message>
            <source>Unreachable</source>
            <translation>Inalcançável</translation>
        </message>
        <message>
            <source>Use the tool of the job</source>
            <translation>Usar a ferramenta do trabalho</translation>
        </message>
        <message>
            <source>V-bit</source>
            <translation>fresa em V</translation>
        </message>
        <message>
            <source>Virtual grbl (no machine)</source>
            <translation>grbl virtual (sem máquina)</translation>
        </message>
        <message>
            <source>Waiting for the controller to answer.</source>
            <translation>Esperando a resposta do controlador.</translation>
        </message>
        <message>
            <source>Waiting for the cut…</source>
            <translation>Esperando o corte…</translation>
        </message>
        <message>
            <source>Wall feed</source>
            <translation>Avanço na parede</translation>
        </message>
        <message>
            <source>Warning</source>
            <translation>Aviso</translation>
        </message>
        <message>
            <source>Warnings</source>
            <translation>Avisos</translation>
        </message>
        <message>
            <source>Water jet</source>
            <translation>Jato de água</translation>
        </message>
        <message>
            <source>What becomes one object</source>
            <translation>O que vira um objeto</translation>
        </message>
        <message>
            <source>What is one step: a line of the program, a move, or a pulse of the motors</source>
            <translation>O que é um passo: uma linha do programa, um movimento ou um pulso dos motores</translation>
        </message>
        <message>
            <source>What is written; several lines are set below each other</source>
            <translation>O que se escreve; várias linhas ficam uma abaixo da outra</translation>
        </message>
        <message>
            <source>What the height is measured of</source>
            <translation>De que se mede a altura</translation>
        </message>
        <message>
            <source>What the letters stand on</source>
            <translation>Sobre o que as letras ficam</translation>
        </message>
        <message>
            <source>What was found in it</source>
            <translation>O que foi achado nele</translation>
        </message>
        <message>
            <source>What was read</source>
            <translation>O que foi lido</translation>
        </message>
        <message>
            <source>Where rapids travel across the work</source>
            <translation>Altura dos movimentos rápidos sobre a peça</translation>
        </message>
        <message>
            <source>Where the arc begins; counter-clockwise from X</source>
            <translation>Onde o arco começa; anti-horário a partir de X</translation>
        </message>
        <message>
            <source>Where the line begins</source>
            <translation>Onde a linha começa</translation>
        </message>
        <message>
            <source>Where the line ends</source>
            <translation>Onde a linha termina</translation>
        </message>
        <message>
            <source>Where the row begins, from the work zero</source>
            <translation>Onde a fileira começa, a partir do zero da peça</translation>
        </message>
        <message>
            <source>Where the row ends</source>
            <translation>Onde a fileira termina</translation>
        </message>
        <message>
            <source>Where the text stands about its zero, or on its line</source>
            <translation>Onde o texto fica em torno de seu zero, ou em sua linha</translation>
        </message>
        <message>
            <source>Whether a laser's power follows its speed (M4)</source>
            <translation>Se a potência do laser acompanha a velocidade (M4)</translation>
        </message>
        <message>
            <source>Whether a slit through the part leads the wire into a closed hole</source>
            <translation>Se uma fenda através da peça leva o fio a um furo fechado</translation>
        </message>
        <message>
            <source>Whether all of its chains are closed</source>
            <translation>Se todos os seus contornos são fechados</translation>
        </message>
        <message>
            <source>Whether form, kerf and feeds are those of the job's cut chart</source>
            <translation>Se forma, largura do corte e avanços são os da tabela de corte do trabalho</translation>
        </message>
        <message>
            <source>Whether inner corners are opened, so that a square corner fits in</source>
            <translation>Se os cantos internos são abertos para que um canto vivo caiba</translation>
        </message>
        <message>
            <source>Whether the depth is that of the point or of the full diameter</source>
            <translation>Se a profundidade é a da ponta ou a do diâmetro pleno</translation>
        </message>
        <message>
            <source>Whether the file fills it</source>
            <translation>Se o arquivo o preenche</translation>
        </message>
        <message>
            <source>Whether the file is as it was read</source>
            <translation>Se o arquivo está como foi lido</translation>
        </message>
        <message>
            <source>Whether the last point joins the first</source>
            <translation>Se o último ponto se une ao primeiro</translation>
        </message>
        <message>
            <source>Whether the program holds it</source>
            <translation>Se o programa a contém</translation>
        </message>
        <message>
            <source>While pressed</source>
            <translation>Enquanto pressionado</translation>
        </message>
        <message>
            <source>Why it cannot be made; empty when it can</source>
            <translation>Por que não pode ser feito; vazio quando pode</translation>
        </message>
        <message>
            <source>Why there is no program</source>
            <translation>Por que não há programa</translation>
        </message>
        <message>
            <source>Width</source>
            <translation>Largura</translation>
        </message>
        <message>
            <source>Width of each flange</source>
            <translation>Largura de cada aba</translation>
        </message>
        <message>
            <source>Width of the bar</source>
            <translation>Largura da barra</translation>
        </message>
        <message>
            <source>Width of the bars</source>
            <translation>Largura das barras</translation>
        </message>
        <message>
            <source>Width of the ears</source>
            <translation>Largura das orelhas</translation>
        </message>
        <message>
            <source>Width of the head</source>
            <translation>Largura da cabeça</translation>
        </message>
        <message>
            <source>Width of the key</source>
            <translation>Largura da chaveta</translation>
        </message>
        <message>
            <source>Width of the legs</source>
            <translation>Largura das abas</translation>
        </message>
        <message>
            <source>Width of the mouth</source>
            <translation>Largura da boca</translation>
        </message>
        <message>
            <source>Width of the shaft</source>
            <translation>Largura da haste</translation>
        </message>
        <message>
            <source>Width of the slot</source>
            <translation>Largura do rasgo</translation>
        </message>
        <message>
            <source>Wire cut</source>
            <translation>Corte com fio</translation>
        </message>
        <message>
            <source>Work</source>
            <translation>Peça</translation>
        </message>
        <message>
            <source>Work offset</source>
            <translation>Sistema de coordenadas</translation>
        </message>
        <message>
            <source>Work out the angle</source>
            <translation>Calcular o ângulo</translation>
        </message>
        <message>
            <source>Work zero</source>
            <translation>Zero-peça</translation>
        </message>
        <message>
            <source>Writes the text into a file</source>
            <translation>Grava o texto em um arquivo</translation>
        </message>
        <message>
            <source>Writing the program…</source>
            <translation>Escrevendo o programa…</translation>
        </message>
        <message>
            <source>Writing the report…</source>
            <translation>Escrevendo o relatório…</translation>
        </message>
        <message>
            <source>X times</source>
            <translation>X vezes</translation>
        </message>
        <message>
            <source>X words are diameters</source>
            <translation>palavras X são diâmetros</translation>
        </message>
        <message>
            <source>X words are radii</source>
            <translation>palavras X são raios</translation>
        </message>
        <message>
            <source>X, steps</source>
            <translation>X, passos</translation>
        </message>
        <message>
            <source>X; Y in {0}, one hole a line</source>
            <translation>X; Y em {0}, um furo por linha</translation>
        </message>
        <message>
            <source>XPS foam</source>
            <translation>espuma XPS</translation>
        </message>
        <message>
            <source>Y times</source>
            <translation>Y vezes</translation>
        </message>
        <message>
            <source>Y, steps</source>
            <translation>Y, passos</translation>
        </message>
        <message>
            <source>Z of the faces or of the section</source>
            <translation>Z das faces ou da seção</translation>
        </message>
        <message>
            <source>Z times</source>
            <translation>Z vezes</translation>
        </message>
        <message>
            <source>Z, steps</source>
            <translation>Z, passos</translation>
        </message>
        <message>
            <source>Z-bracket</source>
            <translation>Suporte em Z</translation>
        </message>
        <message>
            <source>Zero's place</source>
            <translation>Lugar do zero</translation>
        </message>
        <message>
            <source>a comment</source>
            <translation>um comentário</translation>
        </message>
        <message>
            <source>a file for each tool</source>
            <translation>um arquivo por ferramenta</translation>
        </message>
        <message>
            <source>a parameter</source>
            <translation>um parâmetro</translation>
        </message>
        <message>
            <source>a program</source>
            <translation>um programa</translation>
        </message>
        <message>
            <source>absolute</source>
            <translation>absoluto</translation>
        </message>
        <message>
            <source>acrylic, cast</source>
            <translation>acrílico fundido</translation>
        </message>
        <message>
            <source>active low</source>
            <translation>ativo em baixo</translation>
        </message>
        <message>
            <source>ae, recalculated to whole passes</source>
            <translation>ae, recalculada para passes inteiros</translation>
        </message>
        <message>
            <source>all</source>
            <translation>todas</translation>
        </message>
        <message>
            <source>all stand out equally</source>
            <translation>todas salientes por igual</translation>
        </message>
        <message>
            <source>along the walls</source>
            <translation>paralelo</translation>
        </message>
        <message>
            <source>aluminium</source>
            <translation>alumínio</translation>
        </message>
        <message>
            <source>aluminium 6061</source>
            <translation>alumínio 6061</translation>
        </message>
        <message>
            <source>and {0} more</source>
            <translation>e mais {0}</translation>
        </message>
        <message>
            <source>angle about X</source>
            <translation>ângulo em torno de X</translation>
        </message>
        <message>
            <source>angle about Y</source>
            <translation>ângulo em torno de Y</translation>
        </message>
        <message>
            <source>angle about Z</source>
            <translation>ângulo em torno de Z</translation>
        </message>
        <message>
            <source>ap, recalculated to whole passes</source>
            <translation>ap, recalculada para passes inteiros</translation>
        </message>
        <message>
            <source>applies a given tool length</source>
            <translation>leva em conta um comprimento de ferramenta dado</translation>
        </message>
        <message>
            <source>applies the tool's length</source>
            <translation>leva em conta o comprimento da ferramenta</translation>
        </message>
        <message>
            <source>arc</source>
            <translation>arco</translation>
        </message>
        <message>
            <source>arc centre along X</source>
            <translation>centro do arco ao longo de X</translation>
        </message>
        <message>
            <source>arc centre along Y</source>
            <translation>centro do arco ao longo de Y</translation>
        </message>
        <message>
            <source>arc centre along Z</source>
            <translation>centro do arco ao longo de Z</translation>
        </message>
        <message>
            <source>arc centres are absolute</source>
            <translation>centros de arco são absolutos</translation>
        </message>
        <message>
            <source>arc centres are seen from the arc's begin</source>
            <translation>centros de arco são vistos do início do arco</translation>
        </message>
        <message>
            <source>arc, clockwise</source>
            <translation>arco, horário</translation>
        </message>
        <message>
            <source>arc, counter-clockwise</source>
            <translation>arco, anti-horário</translation>
        </message>
        <message>
            <source>arcs lie in the XY plane</source>
            <translation>os arcos ficam no plano XY</translation>
        </message>
        <message>
            <source>arcs lie in the YZ plane</source>
            <translation>os arcos ficam no plano YZ</translation>
        </message>
        <message>
            <source>arcs lie in the ZX plane</source>
            <translation>os arcos ficam no plano ZX</translation>
        </message>
        <message>
            <source>arcs within the tolerance</source>
            <translation>arcos dentro da tolerância</translation>
        </message>
        <message>
            <source>as drawn</source>
            <translation>como desenhada</translation>
        </message>
        <message>
            <source>as given</source>
            <translation>como dada</translation>
        </message>
        <message>
            <source>as the program</source>
            <translation>como o programa</translation>
        </message>
        <message>
            <source>as the thesis published it</source>
            <translation>como publicado na dissertação</translation>
        </message>
        <message>
            <source>at a height</source>
            <translation>a uma altura</translation>
        </message>
        <message>
            <source>at the lower end</source>
            <translation>no extremo inferior</translation>
        </message>
        <message>
            <source>at the upper end</source>
            <translation>no extremo superior</translation>
        </message>
        <message>
            <source>automatic</source>
            <translation>automático</translation>
        </message>
        <message>
            <source>back along the cut</source>
            <translation>volta pelo corte</translation>
        </message>
        <message>
            <source>back along the entry</source>
            <translation>de volta pelo mesmo caminho</translation>
        </message>
        <message>
            <source>backlash {0:g} mm</source>
            <translation>folga {0:g} mm</translation>
        </message>
        <message>
            <source>ball end mill</source>
            <translation>fresa de topo esférico</translation>
        </message>
        <message>
            <source>bolt circle</source>
            <translation>em círculo</translation>
        </message>
        <message>
            <source>bounded engagement</source>
            <translation>engajamento limitado</translation>
        </message>
        <message>
            <source>box</source>
            <translation>bloco</translation>
        </message>
        <message>
            <source>brass</source>
            <translation>latão</translation>
        </message>
        <message>
            <source>bull nose</source>
            <translation>fresa toroidal</translation>
        </message>
        <message>
            <source>by contour</source>
            <translation>por contorno</translation>
        </message>
        <message>
            <source>by layer</source>
            <translation>por camada</translation>
        </message>
        <message>
            <source>by numbers</source>
            <translation>por números</translation>
        </message>
        <message>
            <source>calls a subprogram</source>
            <translation>chama um subprograma</translation>
        </message>
        <message>
            <source>cancels G92</source>
            <translation>desfaz G92</translation>
        </message>
        <message>
            <source>canned cycles return to R</source>
            <translation>ciclos fixos retornam a R</translation>
        </message>
        <message>
            <source>canned cycles return to where they began</source>
            <translation>ciclos fixos retornam aonde começaram</translation>
        </message>
        <message>
            <source>carbide</source>
            <translation>metal duro</translation>
        </message>
        <message>
            <source>carbon fibre</source>
            <translation>fibra de carbono</translation>
        </message>
        <message>
            <source>cardboard</source>
            <translation>papelão</translation>
        </message>
        <message>
            <source>cardstock</source>
            <translation>cartolina</translation>
        </message>
        <message>
            <source>centre of the top</source>
            <translation>centro do topo</translation>
        </message>
        <message>
            <source>changes the tool</source>
            <translation>troca a ferramenta</translation>
        </message>
        <message>
            <source>choose</source>
            <translation>escolha</translation>
        </message>
        <message>
            <source>climb</source>
            <translation>concordante</translation>
        </message>
        <message>
            <source>constant acceleration</source>
            <translation>aceleração constante</translation>
        </message>
        <message>
            <source>conventional</source>
            <translation>discordante</translation>
        </message>
        <message>
            <source>coolant off</source>
            <translation>refrigeração desligada</translation>
        </message>
        <message>
            <source>coordinates are absolute</source>
            <translation>as coordenadas são absolutas</translation>
        </message>
        <message>
            <source>coordinates are steps from where the tool is</source>
            <translation>as coordenadas são passos a partir de onde está a ferramenta</translation>
        </message>
        <message>
            <source>copper</source>
            <translation>cobre</translation>
        </message>
        <message>
            <source>count</source>
            <translation>quantidade</translation>
        </message>
        <message>
            <source>cubic spline</source>
            <translation>spline cúbica</translation>
        </message>
        <message>
            <source>cuts a thread in several passes</source>
            <translation>corta uma rosca em vários passes</translation>
        </message>
        <message>
            <source>cylinder</source>
            <translation>cilindro</translation>
        </message>
        <message>
            <source>depth of a peck</source>
            <translation>profundidade de uma bicada</translation>
        </message>
        <message>
            <source>digital differential analyser</source>
            <translation>analisador diferencial digital (DDA)</translation>
        </message>
        <message>
            <source>drill</source>
            <translation>broca</translation>
        </message>
        <message>
            <source>drills</source>
            <translation>fura</translation>
        </message>
        <message>
            <source>drills with a dwell at the bottom</source>
            <translation>fura com uma pausa no fundo</translation>
        </message>
        <message>
            <source>drills, breaking chips</source>
            <translation>fura, quebrando o cavaco</translation>
        </message>
        <message>
            <source>drills, lifting the chips out</source>
            <translation>fura, retirando o cavaco</translation>
        </message>
        <message>
            <source>drives enabled</source>
            <translation>drivers habilitados</translation>
        </message>
        <message>
            <source>dwell for P</source>
            <translation>pausa de P</translation>
        </message>
        <message>
            <source>end of the program</source>
            <translation>fim do programa</translation>
        </message>
        <message>
            <source>ends the canned cycle</source>
            <translation>encerra o ciclo fixo</translation>
        </message>
        <message>
            <source>engraver</source>
            <translation>ferramenta de gravação</translation>
        </message>
        <message>
            <source>exceeds the machine's travel; at most {0}</source>
            <translation>vai além do curso da máquina; no máximo {0}</translation>
        </message>
        <message>
            <source>feed</source>
            <translation>avanço</translation>
        </message>
        <message>
            <source>felt</source>
            <translation>feltro</translation>
        </message>
        <message>
            <source>first of the chart</source>
            <translation>o primeiro da tabela</translation>
        </message>
        <message>
            <source>flat end mill</source>
            <translation>fresa de topo reto</translation>
        </message>
        <message>
            <source>flood</source>
            <translation>jato</translation>
        </message>
        <message>
            <source>flood (M8)</source>
            <translation>jato (M8)</translation>
        </message>
        <message>
            <source>flood on</source>
            <translation>jato ligado</translation>
        </message>
        <message>
            <source>flood on/off</source>
            <translation>jato liga/desliga</translation>
        </message>
        <message>
            <source>foam</source>
            <translation>espuma</translation>
        </message>
        <message>
            <source>foam board</source>
            <translation>placa de espuma</translation>
        </message>
        <message>
            <source>follows the path exactly</source>
            <translation>segue a trajetória exatamente</translation>
        </message>
        <message>
            <source>front</source>
            <translation>frente</translation>
        </message>
        <message>
            <source>front left corner of the top</source>
            <translation>canto frontal esquerdo do topo</translation>
        </message>
        <message>
            <source>full diameter</source>
            <translation>diâmetro pleno</translation>
        </message>
        <message>
            <source>glass</source>
            <translation>vidro</translation>
        </message>
        <message>
            <source>goes far beyond the machine's fastest axis; at most {0}</source>
            <translation>vai muito além do eixo mais rápido da máquina; no máximo {0}</translation>
        </message>
        <message>
            <source>goes far beyond the stock and the machine; at most {0}</source>
            <translation>vai muito além da peça bruta e da máquina; no máximo {0}</translation>
        </message>
        <message>
            <source>goes far beyond the stock; at most {0}</source>
            <translation>vai muito além da peça bruta; no máximo {0}</translation>
        </message>
        <message>
            <source>goes to the first stored place</source>
            <translation>vai ao primeiro lugar guardado</translation>
        </message>
        <message>
            <source>goes to the second stored place</source>
            <translation>vai ao segundo lugar guardado</translation>
        </message>
        <message>
            <source>granite</source>
            <translation>granito</translation>
        </message>
        <message>
            <source>grid</source>
            <translation>grade</translation>
        </message>
        <message>
            <source>ground</source>
            <translation>terra</translation>
        </message>
        <message>
            <source>hardwood</source>
            <translation>madeira dura</translation>
        </message>
        <message>
            <source>heat transfer film</source>
            <translation>filme termotransferível</translation>
        </message>
        <message>
            <source>helix</source>
            <translation>hélice</translation>
        </message>
        <message>
            <source>high</source>
            <translation>alto</translation>
        </message>
        <message>
            <source>high-speed steel</source>
            <translation>aço rápido</translation>
        </message>
        <message>
            <source>holes</source>
            <translation>furos</translation>
        </message>
        <message>
            <source>how often, or which</source>
            <translation>quantas vezes, ou qual</translation>
        </message>
        <message>
            <source>inches (G20)</source>
            <translation>polegadas (G20)</translation>
        </message>
        <message>
            <source>incremental</source>
            <translation>incremental</translation>
        </message>
        <message>
            <source>input</source>
            <translation>entrada</translation>
        </message>
        <message>
            <source>inside</source>
            <translation>por dentro</translation>
        </message>
        <message>
            <source>into one side</source>
            <translation>para um lado</translation>
        </message>
        <message>
            <source>into the corner</source>
            <translation>para o canto</translation>
        </message>
        <message>
            <source>inverse time</source>
            <translation>tempo inverso</translation>
        </message>
        <message>
            <source>jet (water, plasma, laser)</source>
            <translation>jato (água, plasma, laser)</translation>
        </message>
        <message>
            <source>leads the program elsewhere</source>
            <translation>leva o programa a outro lugar</translation>
        </message>
        <message>
            <source>leather</source>
            <translation>couro</translation>
        </message>
        <message>
            <source>left</source>
            <translation>esquerda</translation>
        </message>
        <message>
            <source>lengths are inches</source>
            <translation>os comprimentos são polegadas</translation>
        </message>
        <message>
            <source>lengths are millimetres</source>
            <translation>os comprimentos são milímetros</translation>
        </message>
        <message>
            <source>limit switch</source>
            <translation>fim de curso</translation>
        </message>
        <message>
            <source>limit {0}</source>
            <translation>limite {0}</translation>
        </message>
        <message>
            <source>line</source>
            <translation>linha</translation>
        </message>
        <message>
            <source>line {0}, column {1}</source>
            <translation>linha {0}, coluna {1}</translation>
        </message>
        <message>
            <source>lines in one direction</source>
            <translation>linhas em um só sentido</translation>
        </message>
        <message>
            <source>low</source>
            <translation>baixo</translation>
        </message>
        <message>
            <source>make room in the folder for temporary files</source>
            <translation>libere espaço na pasta de arquivos temporários</translation>
        </message>
        <message>
            <source>middle</source>
            <translation>meio</translation>
        </message>
        <message>
            <source>mild steel</source>
            <translation>aço doce</translation>
        </message>
        <message>
            <source>millimetres (G21)</source>
            <translation>milímetros (G21)</translation>
        </message>
        <message>
            <source>mist</source>
            <translation>névoa</translation>
        </message>
        <message>
            <source>mist (M7)</source>
            <translation>névoa (M7)</translation>
        </message>
        <message>
            <source>mist on</source>
            <translation>névoa ligada</translation>
        </message>
        <message>
            <source>mist on/off</source>
            <translation>névoa liga/desliga</translation>
        </message>
        <message>
            <source>mm</source>
            <translation>mm</translation>
        </message>
        <message>
            <source>moves in step with the spindle</source>
            <translation>move-se em sincronia com o fuso</translation>
        </message>
        <message>
            <source>must be 0, or at least {0}</source>
            <translation>deve ser 0, ou no mínimo {0}</translation>
        </message>
        <message>
            <source>must be above {0}</source>
            <translation>deve ser maior que {0}</translation>
        </message>
        <message>
            <source>must be at least {0}</source>
            <translation>deve ser no mínimo {0}</translation>
        </message>
        <message>
            <source>must be at most {0}</source>
            <translation>deve ser no máximo {0}</translation>
        </message>
        <message>
            <source>must be below {0}</source>
            <translation>deve ser menor que {0}</translation>
        </message>
        <message>
            <source>names the present place</source>
            <translation>dá nome ao lugar atual</translation>
        </message>
        <message>
            <source>nichrome wire, 0.4 mm</source>
            <translation>fio de níquel-cromo, 0,4 mm</translation>
        </message>
        <message>
            <source>no cutter compensation</source>
            <translation>sem compensação da ferramenta</translation>
        </message>
        <message>
            <source>no errors</source>
            <translation>nenhum erro</translation>
        </message>
        <message>
            <source>no switch</source>
            <translation>sem chave</translation>
        </message>
        <message>
            <source>no tool length</source>
            <translation>sem comprimento de ferramenta</translation>
        </message>
        <message>
            <source>none</source>
            <translation>nenhuma</translation>
        </message>
        <message>
            <source>none yet</source>
            <translation>nenhum ainda</translation>
        </message>
        <message>
            <source>not given</source>
            <translation>não informado</translation>
        </message>
        <message>
            <source>nothing</source>
            <translation>nada</translation>
        </message>
        <message>
            <source>nothing is marked</source>
            <translation>nada é marcado</translation>
        </message>
        <message>
            <source>nothing to correct</source>
            <translation>nada a corrigir</translation>
        </message>
        <message>
            <source>number of the line</source>
            <translation>número da linha</translation>
        </message>
        <message>
            <source>number of the tool</source>
            <translation>número da ferramenta</translation>
        </message>
        <message>
            <source>number of the tool for compensation</source>
            <translation>número da ferramenta para a compensação</translation>
        </message>
        <message>
            <source>number of the tool length</source>
            <translation>número do comprimento da ferramenta</translation>
        </message>
        <message>
            <source>of a drawing</source>
            <translation>de um desenho</translation>
        </message>
        <message>
            <source>off</source>
            <translation>desligado</translation>
        </message>
        <message>
            <source>off when pressed</source>
            <translation>desligado ao apertar</translation>
        </message>
        <message>
            <source>offsets from a table</source>
            <translation>compensações de uma tabela</translation>
        </message>
        <message>
            <source>on the line</source>
            <translation>sobre a linha</translation>
        </message>
        <message>
            <source>on when pressed</source>
            <translation>ligado ao apertar</translation>
        </message>
        <message>
            <source>open a document or its 3D view</source>
            <translation>abra um documento ou a sua vista 3D</translation>
        </message>
        <message>
            <source>open one and simulate again</source>
            <translation>abra uma e simule de novo</translation>
        </message>
        <message>
            <source>our planner</source>
            <translation>nosso planejador</translation>
        </message>
        <message>
            <source>outline</source>
            <translation>contorno</translation>
        </message>
        <message>
            <source>outlines</source>
            <translation>contornos</translation>
        </message>
        <message>
            <source>output</source>
            <translation>saída</translation>
        </message>
        <message>
            <source>output 0 (M64 P0)</source>
            <translation>saída 0 (M64 P0)</translation>
        </message>
        <message>
            <source>output 1 (M64 P1)</source>
            <translation>saída 1 (M64 P1)</translation>
        </message>
        <message>
            <source>output 2 (M64 P2)</source>
            <translation>saída 2 (M64 P2)</translation>
        </message>
        <message>
            <source>output 3 (M64 P3)</source>
            <translation>saída 3 (M64 P3)</translation>
        </message>
        <message>
            <source>outside</source>
            <translation>por fora</translation>
        </message>
        <message>
            <source>own values</source>
            <translation>valores próprios</translation>
        </message>
        <message>
            <source>paper</source>
            <translation>papel</translation>
        </message>
        <message>
            <source>pause</source>
            <translation>pausa</translation>
        </message>
        <message>
            <source>pause, by hand</source>
            <translation>pausa, à mão</translation>
        </message>
        <message>
            <source>pauses if optional stop is on</source>
            <translation>pausa quando o operador quer</translation>
        </message>
        <message>
            <source>pauses until cycle start</source>
            <translation>pausa até que mandem continuar</translation>
        </message>
        <message>
            <source>place along U</source>
            <translation>posição ao longo de U</translation>
        </message>
        <message>
            <source>place along V</source>
            <translation>posição ao longo de V</translation>
        </message>
        <message>
            <source>place along W</source>
            <translation>posição ao longo de W</translation>
        </message>
        <message>
            <source>place along X</source>
            <translation>posição ao longo de X</translation>
        </message>
        <message>
            <source>place along Y</source>
            <translation>posição ao longo de Y</translation>
        </message>
        <message>
            <source>place along Z</source>
            <translation>posição ao longo de Z</translation>
        </message>
        <message>
            <source>plywood</source>
            <translation>compensado</translation>
        </message>
        <message>
            <source>points</source>
            <translation>pontos</translation>
        </message>
        <message>
            <source>polycarbonate</source>
            <translation>policarbonato</translation>
        </message>
        <message>
            <source>probes away until the contact opens</source>
            <translation>sonda afastando até soltar</translation>
        </message>
        <message>
            <source>probes away until the contact opens; otherwise an alarm</source>
            <translation>sonda afastando até soltar; alarme se não soltar</translation>
        </message>
        <message>
            <source>probes until it touches</source>
            <translation>sonda até tocar</translation>
        </message>
        <message>
            <source>probes until it touches, an alarm where it does not</source>
            <translation>sonda até tocar; alarme se não tocar</translation>
        </message>
        <message>
            <source>profile: {0}</source>
            <translation>perfil: {0}</translation>
        </message>
        <message>
            <source>published points (DDA)</source>
            <translation>pontos publicados (DDA)</translation>
        </message>
        <message>
            <source>pulsing</source>
            <translation>com pulsos</translation>
        </message>
        <message>
            <source>quadratic spline</source>
            <translation>spline quadrática</translation>
        </message>
        <message>
            <source>radius, or where a canned cycle begins</source>
            <translation>raio, ou onde um ciclo fixo começa</translation>
        </message>
        <message>
            <source>ramp</source>
            <translation>rampa</translation>
        </message>
        <message>
            <source>rapid</source>
            <translation>rápido</translation>
        </message>
        <message>
            <source>rapid: straight, as fast as the machine can</source>
            <translation>rápido: reto, tão rápido quanto a máquina pode</translation>
        </message>
        <message>
            <source>rear</source>
            <translation>fundo</translation>
        </message>
        <message>
            <source>returns from a subprogram</source>
            <translation>retorna de um subprograma</translation>
        </message>
        <message>
            <source>right</source>
            <translation>direita</translation>
        </message>
        <message>
            <source>rounds corners off to keep its speed</source>
            <translation>arredonda cantos para manter a velocidade</translation>
        </message>
        <message>
            <source>rubber</source>
            <translation>borracha</translation>
        </message>
        <message>
            <source>safety door</source>
            <translation>porta de segurança</translation>
        </message>
        <message>
            <source>sandblast film</source>
            <translation>filme para jateamento</translation>
        </message>
        <message>
            <source>sets offsets or tools</source>
            <translation>define deslocamentos ou ferramentas</translation>
        </message>
        <message>
            <source>sheet</source>
            <translation>chapa</translation>
        </message>
        <message>
            <source>shipped; your first change makes a copy of it</source>
            <translation>fornecido; sua primeira mudança faz uma cópia</translation>
        </message>
        <message>
            <source>short rapids</source>
            <translation>rápidos curtos</translation>
        </message>
        <message>
            <source>softwood</source>
            <translation>madeira macia</translation>
        </message>
        <message>
            <source>spacing</source>
            <translation>distância</translation>
        </message>
        <message>
            <source>speed of the spindle</source>
            <translation>velocidade do fuso</translation>
        </message>
        <message>
            <source>spindle</source>
            <translation>fuso</translation>
        </message>
        <message>
            <source>spindle off</source>
            <translation>fuso desligado</translation>
        </message>
        <message>
            <source>spindle on, clockwise</source>
            <translation>fuso ligado, horário</translation>
        </message>
        <message>
            <source>spindle on, counter-clockwise</source>
            <translation>fuso ligado, anti-horário</translation>
        </message>
        <message>
            <source>spindle reversed (M4)</source>
            <translation>fuso invertido (M4)</translation>
        </message>
        <message>
            <source>spindle stop</source>
            <translation>parada do fuso</translation>
        </message>
        <message>
            <source>spindle, torch or beam (M3)</source>
            <translation>fuso, maçarico ou feixe (M3)</translation>
        </message>
        <message>
            <source>spiral</source>
            <translation>espiral</translation>
        </message>
        <message>
            <source>stainless steel</source>
            <translation>aço inoxidável</translation>
        </message>
        <message>
            <source>start</source>
            <translation>início</translation>
        </message>
        <message>
            <source>stay on</source>
            <translation>continuam ligadas</translation>
        </message>
        <message>
            <source>steps per mm {0:g} becomes {1:g}</source>
            <translation>passos por mm {0:g} passa a {1:g}</translation>
        </message>
        <message>
            <source>stop</source>
            <translation>parada</translation>
        </message>
        <message>
            <source>straight cut, at the feed F</source>
            <translation>corte reto, no avanço F</translation>
        </message>
        <message>
            <source>straight down</source>
            <translation>na vertical</translation>
        </message>
        <message>
            <source>switch by lines</source>
            <translation>ligar por linhas</translation>
        </message>
        <message>
            <source>table of step times</source>
            <translation>tabela de tempos de passo</translation>
        </message>
        <message>
            <source>the capitals</source>
            <translation>as maiúsculas</translation>
        </message>
        <message>
            <source>the cutter runs left of the path</source>
            <translation>a fresa corre à esquerda da trajetória</translation>
        </message>
        <message>
            <source>the cutter runs right of the path</source>
            <translation>a fresa corre à direita da trajetória</translation>
        </message>
        <message>
            <source>the em (font size)</source>
            <translation>o corpo da fonte (em)</translation>
        </message>
        <message>
            <source>the machine's own</source>
            <translation>o da máquina</translation>
        </message>
        <message>
            <source>the nearest edge</source>
            <translation>a borda mais próxima</translation>
        </message>
        <message>
            <source>the one that ships</source>
            <translation>a que acompanha o programa</translation>
        </message>
        <message>
            <source>the point</source>
            <translation>a ponta</translation>
        </message>
        <message>
            <source>the whole stock</source>
            <translation>o bloco todo</translation>
        </message>
        <message>
            <source>there is no 3D view to draw in</source>
            <translation>não há vista 3D em que desenhar</translation>
        </message>
        <message>
            <source>this document has no 3D view</source>
            <translation>este documento não tem vista 3D</translation>
        </message>
        <message>
            <source>this line is in machine coordinates</source>
            <translation>esta linha está em coordenadas de máquina</translation>
        </message>
        <message>
            <source>this line is not run</source>
            <translation>esta linha não é executada</translation>
        </message>
        <message>
            <source>time, number or turns, as the code has it</source>
            <translation>tempo, número ou voltas, conforme o código</translation>
        </message>
        <message>
            <source>titanium</source>
            <translation>titânio</translation>
        </message>
        <message>
            <source>to the nearest edge</source>
            <translation>pela borda mais próxima</translation>
        </message>
        <message>
            <source>tool {0}</source>
            <translation>ferramenta {0}</translation>
        </message>
        <message>
            <source>usual</source>
            <translation>usual</translation>
        </message>
        <message>
            <source>usual for the process</source>
            <translation>usuais do processo</translation>
        </message>
        <message>
            <source>usual: {0}</source>
            <translation>usual: {0}</translation>
        </message>
        <message>
            <source>value {0}</source>
            <translation>valor {0}</translation>
        </message>
        <message>
            <source>vinyl</source>
            <translation>vinil</translation>
        </message>
        <message>
            <source>wire</source>
            <translation>fio</translation>
        </message>
        <message>
            <source>work zero {0} of 9</source>
            <translation>zero de trabalho {0} de 9</translation>
        </message>
        <message>
            <source>write points as: 0 1.2; 300 1.0</source>
            <translation>escreva os pontos assim: 0 1.2; 300 1.0</translation>
        </message>
        <message>
            <source>yours</source>
            <translation>seu</translation>
        </message>
        <message>
            <source>zero set with each tool</source>
            <translation>zero com cada ferramenta</translation>
        </message>
        <message>
            <source>zigzag</source>
            <translation>ziguezague</translation>
        </message>
        <message>
            <source>{0} %</source>
            <translation>{0} %</translation>
        </message>
        <message>
            <source>{0} (deleted)</source>
            <translation>{0} (apagado)</translation>
        </message>
        <message>
            <source>{0} (edited)</source>
            <translation>{0} (editado)</translation>
        </message>
        <message>
            <source>{0} (single lines)</source>
            <translation>{0} (linhas únicas)</translation>
        </message>
        <message>
            <source>{0} = 0</source>
            <translation>{0} = 0</translation>
        </message>
        <message>
            <source>{0} direction</source>
            <translation>direção {0}</translation>
        </message>
        <message>
            <source>{0} does not name this process</source>
            <translation>{0} não tem este processo</translation>
        </message>
        <message>
            <source>{0} errors</source>
            <translation>{0} erros</translation>
        </message>
        <message>
            <source>{0} from below, {1} from above</source>
            <translation>{0} de baixo, {1} de cima</translation>
        </message>
        <message>
            <source>{0} has changed in the document; your typed values are kept here</source>
            <translation>{0} mudou no documento enquanto isso; aqui ainda está o que você digitou</translation>
        </message>
        <message>
            <source>{0} has changes that are not saved.</source>
            <translation>{0} tem alterações que não foram salvas.</translation>
        </message>
        <message>
            <source>{0} has changes that are not saved. They must be saved before it is checked or sent.</source>
            <translation>{0} tem alterações que não foram salvas. É preciso salvá-las antes de verificar ou enviar.</translation>
        </message>
        <message>
            <source>{0} has nothing to cut: add an operation</source>
            <translation>{0} não tem o que usinar: adicione uma operação</translation>
        </message>
        <message>
            <source>{0} is as its file again</source>
            <translation>{0} está de novo como seu arquivo</translation>
        </message>
        <message>
            <source>{0} is cut with it; choose another tool there first</source>
            <translation>{0} é usinada com ela; escolha antes outra ferramenta lá</translation>
        </message>
        <message>
            <source>{0} is no operation and is not moved</source>
            <translation>{0} não é uma operação e não é movido</translation>
        </message>
        <message>
            <source>{0} is written.</source>
            <translation>{0} foi gravado.</translation>
        </message>
        <message>
            <source>{0} is {1} now: save it.</source>
            <translation>{0} agora é {1}: salve.</translation>
        </message>
        <message>
            <source>{0} lines change:</source>
            <translation>{0} linhas mudam:</translation>
        </message>
        <message>
            <source>{0} mm</source>
            <translation>{0} mm</translation>
        </message>
        <message>
            <source>{0} more contours: choose them by line, or in the 3D view.</source>
            <translation>Mais {0} contornos: escolha-os pela linha ou na vista 3D.</translation>
        </message>
        <message>
            <source>{0} moves</source>
            <translation>{0} movimentos</translation>
        </message>
        <message>
            <source>{0} of {1}</source>
            <translation>{0} de {1}</translation>
        </message>
        <message>
            <source>{0} of {1} lines, line {2} of the file, sent to line {3}</source>
            <translation>{0} de {1} linhas, linha {2} do arquivo, enviado até a linha {3}</translation>
        </message>
        <message>
            <source>{0} on layer '{1}' at X {2} Y {3}</source>
            <translation>{0} na camada '{1}' em X {2} Y {3}</translation>
        </message>
        <message>
            <source>{0} on layer '{1}' was left out: {2}</source>
            <translation>{0} na camada '{1}' foi deixado de fora: {2}</translation>
        </message>
        <message>
            <source>{0} readings: mean {1:.4f} mm, standard deviation {2:.4f} mm</source>
            <translation>{0} leituras: média {1:.4f} mm, desvio padrão {2:.4f} mm</translation>
        </message>
        <message>
            <source>{0} replaced</source>
            <translation>{0} substituídos</translation>
        </message>
        <message>
            <source>{0} rpm</source>
            <translation>{0} rpm</translation>
        </message>
        <message>
            <source>{0} stays in its job: drop it on another operation, or on the job</source>
            <translation>{0} fica no seu trabalho: solte-a sobre outra operação ou sobre o trabalho</translation>
        </message>
        <message>
            <source>{0} stays in its job; copy and paste it into another document</source>
            <translation>{0} fica no seu trabalho; para levá-la a outro documento, copie e cole</translation>
        </message>
        <message>
            <source>{0} step</source>
            <translation>passo {0}</translation>
        </message>
        <message>
            <source>{0} tools imported</source>
            <translation>{0} ferramentas importadas</translation>
        </message>
        <message>
            <source>{0} was not cut to its end, and no open document has the program that was sent.</source>
            <translation>{0} não foi cortado até o fim, e seu programa, como foi enviado, não está em nenhum documento aberto.</translation>
        </message>
        <message>
            <source>{0} was opened</source>
            <translation>{0} foi aberto</translation>
        </message>
        <message>
            <source>{0} was written</source>
            <translation>{0} foi gravado</translation>
        </message>
        <message>
            <source>{0} ×</source>
            <translation>{0} ×</translation>
        </message>
        <message>
            <source>{0} × {1} mm, layers: {2}, open contours: {3}, the file's unit: {4} mm</source>
            <translation>{0} × {1} mm, camadas: {2}, contornos abertos: {3}, unidade do arquivo: {4} mm</translation>
        </message>
        <message>
            <source>{0}, cut until {1}</source>
            <translation>{0}, cortada até {1}</translation>
        </message>
        <message>
            <source>{0}, line {1}</source>
            <translation>{0}, linha {1}</translation>
        </message>
        <message>
            <source>{0}, restart</source>
            <translation>{0}, reinício</translation>
        </message>
        <message>
            <source>{0}. Now {1}</source>
            <translation>{0}. Agora {1}</translation>
        </message>
        <message>
            <source>{0}:</source>
            <translation>{0}:</translation>
        </message>
        <message>
            <source>{0}: its file has changed; Reload in the tree takes it anew</source>
            <translation>{0}: seu arquivo mudou; Recarregar na árvore o lê de novo</translation>
        </message>
        <message>
            <source>{0}: its file is not there any more; what was read stays</source>
            <translation>{0}: seu arquivo não está mais lá; o que foi lido fica</translation>
        </message>
        <message>
            <source>{0}: {1}</source>
            <translation>{0}: {1}</translation>
        </message>
        <message>
            <source>{0}: {1} points, within {2:g} mm of the drawn line. Draw the next one, or Esc: end drawing.</source>
            <translation>{0}: {1} pontos, a até {2:g} mm da linha desenhada. Desenhe a próxima, ou Esc: encerrar.</translation>
        </message>
        <message>
            <source>{0}× speed</source>
            <translation>velocidade {0}×</translation>
        </message>
        <message>
            <source>… and {0} more</source>
            <translation>… e mais {0}</translation>
        </message>
        <message>
            <source>… and {0} more lines</source>
            <translation>… e mais {0} linhas</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper core</name>
        <message>
            <source>! is a command to the controller (feed hold), not part of a program</source>
            <translation>! é um comando para o controlador (parar o avanço), não faz parte de um programa</translation>
        </message>
        <message>
            <source>#&lt;{name}&gt; has no value here</source>
            <translation>#&lt;{name}&gt; não tem valor aqui</translation>
        </message>
        <message>
            <source>${number} is {value:g}, wanted {wanted:g}</source>
            <translation>${number} é {value:g}, esperado {wanted:g}</translation>
        </message>
        <message>
            <source>% may stand only alone on a line</source>
            <translation>% só pode ficar sozinho em uma linha</translation>
        </message>
        <message>
            <source>% may stand only on the first and the last line</source>
            <translation>% só pode ficar na primeira e na última linha</translation>
        </message>
        <message>
            <source>'cncstepper drawing' prints its layers and colours</source>
            <translation>'cncstepper drawing' mostra as camadas e cores dele</translation>
        </message>
        <message>
            <source>'{axes}' names no axes</source>
            <translation>'{axes}' não indica eixos</translation>
        </message>
        <message>
            <source>'{code}' is no insert of ISO 1832</source>
            <translation>'{code}' não é uma pastilha da ISO 1832</translation>
        </message>
        <message>
            <source>'{designation}' is no designation of a thread</source>
            <translation>'{designation}' não é a designação de uma rosca</translation>
        </message>
        <message>
            <source>'{drawing}' holds no lines that can be followed</source>
            <translation>'{drawing}' não contém linhas que possam ser seguidas</translation>
        </message>
        <message>
            <source>'{drawing}' is a solid</source>
            <translation>'{drawing}' é um sólido</translation>
        </message>
        <message>
            <source>'{drawing}' is one more drawing beside '{used}', and only one gives the shape</source>
            <translation>'{drawing}' é mais um desenho ao lado de '{used}', e só um dá a forma</translation>
        </message>
        <message>
            <source>'{each}' is no operation of '{job}'</source>
            <translation>'{each}' não é uma operação de '{job}'</translation>
        </message>
        <message>
            <source>'{file}' is no kind of sheet that can be written</source>
            <translation>'{file}' não é um tipo de folha que se possa gravar</translation>
        </message>
        <message>
            <source>'{inner}' and '{outer}' cross, so that it is not clear what lies inside</source>
            <translation>'{inner}' e '{outer}' se cruzam, de modo que não está claro o que fica dentro</translation>
        </message>
        <message>
            <source>'{insert}' is no insert of a {kind} tool</source>
            <translation>'{insert}' não é pastilha de uma ferramenta {kind}</translation>
        </message>
        <message>
            <source>'{key}' cannot be {value!r}</source>
            <translation>'{key}' não pode ser {value!r}</translation>
        </message>
        <message>
            <source>'{label}' is drawn where '{other}' is, and counts once</source>
            <translation>'{label}' está desenhado onde está '{other}' e conta uma só vez</translation>
        </message>
        <message>
            <source>'{line}' is no block that only switches, as M8, M3S9000 or M64P0</source>
            <translation>'{line}' não é um bloco que só comuta, como M8, M3S9000 ou M64P0</translation>
        </message>
        <message>
            <source>'{name}' is no name for a machine profile</source>
            <translation>'{name}' não é nome de perfil de máquina</translation>
        </message>
        <message>
            <source>'{name}' names no port number</source>
            <translation>'{name}' não indica um número de porta</translation>
        </message>
        <message>
            <source>'{obj}' stands on this job and cannot be its clamp</source>
            <translation>'{obj}' depende deste trabalho e não pode ser grampo dele</translation>
        </message>
        <message>
            <source>'{origin}' is no origin of a stock</source>
            <translation>'{origin}' não é uma origem de bloco</translation>
        </message>
        <message>
            <source>'{out}' is drawn where '{kept}' is, and counts once</source>
            <translation>'{out}' está desenhado onde está '{kept}' e conta uma só vez</translation>
        </message>
        <message>
            <source>'{path}' is no tool file that is known</source>
            <translation>'{path}' não é um arquivo de ferramentas conhecido</translation>
        </message>
        <message>
            <source>'{solid}' is no solid and cannot be a clamp</source>
            <translation>'{solid}' não é um sólido e não pode ser grampo</translation>
        </message>
        <message>
            <source>'{text}' is a move whose end only the controller knows</source>
            <translation>'{text}' move como só o controlador sabe</translation>
        </message>
        <message>
            <source>'{text}' is no tool of a lathe</source>
            <translation>'{text}' não é ferramenta de torno</translation>
        </message>
        <message>
            <source>'{text}' is not a tool</source>
            <translation>'{text}' não é uma ferramenta</translation>
        </message>
        <message>
            <source>'{value}' is no feed for programs without F</source>
            <translation>'{value}' não é um avanço para programas sem F</translation>
        </message>
        <message>
            <source>'{words}' is no length or angle that is known</source>
            <translation>'{words}' não é um comprimento ou ângulo conhecido</translation>
        </message>
        <message>
            <source>'{word}' changes no key</source>
            <translation>'{word}' não muda nenhuma chave</translation>
        </message>
        <message>
            <source>(begin operation: {0})</source>
            <translation>(begin operation: {0})</translation>
        </message>
        <message>
            <source>(finish operation: {0})</source>
            <translation>(finish operation: {0})</translation>
        </message>
        <message>
            <source>(nu=7, ph=3.8, pd=0.4, ch=1.5, fr=3850, kw=1.5)</source>
            <translation>(nu=7, ph=3.8, pd=0.4, ch=1.5, fr=3850, kw=1.5)</translation>
        </message>
        <message>
            <source>(program {number} of {count}, tool {tool})</source>
            <translation>(programa {number} de {count}, ferramenta {tool})</translation>
        </message>
        <message>
            <source>({0}: {1} stretches arranged)</source>
            <translation>({0}: {1} trechos dispostos)</translation>
        </message>
        <message>
            <source>/ (block delete) may stand only at the beginning of a line</source>
            <translation>/ (bloco opcional) só pode ficar no início de uma linha</translation>
        </message>
        <message>
            <source>0 to {most}, or -1</source>
            <translation>0 a {most}, ou -1</translation>
        </message>
        <message>
            <source>0 to {size_mm:g} mm</source>
            <translation>0 a {size_mm:g} mm</translation>
        </message>
        <message>
            <source>0 without an entry slit</source>
            <translation>0 sem fenda de entrada</translation>
        </message>
        <message>
            <source>0.005 mm apart</source>
            <translation>0.005 mm de diferença</translation>
        </message>
        <message>
            <source>0.87 times the width</source>
            <translation>0,87 vezes a largura</translation>
        </message>
        <message>
            <source>00 to 99, in tenths of a mm</source>
            <translation>00 a 99, em décimos de mm</translation>
        </message>
        <message>
            <source>= is missing after the parameter</source>
            <translation>falta = depois do parâmetro</translation>
        </message>
        <message>
            <source>? is a command to the controller (status), not part of a program</source>
            <translation>? é um comando para o controlador (estado), não faz parte de um programa</translation>
        </message>
        <message>
            <source>@ and ^ lie in the plane XY</source>
            <translation>@ e ^ ficam no plano XY</translation>
        </message>
        <message>
            <source>@ and ^ stand for X and Y</source>
            <translation>@ e ^ ficam no lugar de X e Y</translation>
        </message>
        <message>
            <source>A bar above and a stem below, the zero in the middle of the bar's upper edge; three holes.</source>
            <translation>Uma barra em cima e uma haste embaixo, o zero no meio da borda superior da barra; três furos.</translation>
        </message>
        <message>
            <source>A bore about the zero with a keyway above (DIN 6885: bore and key's depth over all).</source>
            <translation>Um furo em torno do zero com rasgo de chaveta em cima (DIN 6885: furo e profundidade total da chaveta).</translation>
        </message>
        <message>
            <source>A circle about the zero.</source>
            <translation>Um círculo em torno do zero.</translation>
        </message>
        <message>
            <source>A cross of two bars about the zero.</source>
            <translation>Uma cruz de duas barras em torno do zero.</translation>
        </message>
        <message>
            <source>A disc about the zero less another one beside it, like a moon.</source>
            <translation>Um disco em torno do zero menos outro ao lado, como uma lua.</translation>
        </message>
        <message>
            <source>A disc about the zero with round notches in its rim and a bore.</source>
            <translation>Um disco em torno do zero com entalhes redondos na borda e um furo.</translation>
        </message>
        <message>
            <source>A disc about the zero, cut off straight above.</source>
            <translation>Um disco em torno do zero, cortado reto em cima.</translation>
        </message>
        <message>
            <source>A drop: a disc about the zero and a point above.</source>
            <translation>Uma gota: um disco em torno do zero e uma ponta em cima.</translation>
        </message>
        <message>
            <source>A flange of two bolts along X: a disc about the zero with an ear on each side.</source>
            <translation>Um flange de dois parafusos ao longo de X: um disco em torno do zero com uma orelha de cada lado.</translation>
        </message>
        <message>
            <source>A heart of two half circles over a rounded tip, the zero in its notch.</source>
            <translation>Um coração de dois semicírculos sobre uma ponta, o zero no entalhe.</translation>
        </message>
        <message>
            <source>A hole to hang a part on a screw: a circle about the zero for its head, a slot above for its shank.</source>
            <translation>Um furo para pendurar a peça em um parafuso: um círculo em torno do zero para a cabeça, um rasgo em cima para o corpo.</translation>
        </message>
        <message>
            <source>A hook to hang things on: a plate with two holes above, the hook's round inside about the zero.</source>
            <translation>Um gancho para pendurar coisas: uma chapa com dois furos em cima, o interior do gancho em torno do zero.</translation>
        </message>
        <message>
            <source>A label about the zero: round corners, cut off on the left, with a hole for a string.</source>
            <translation>Uma etiqueta em torno do zero: cantos redondos, cortada à esquerda, com um furo para o cordão.</translation>
        </message>
        <message>
            <source>A parallelogram, its left lower corner at the zero.</source>
            <translation>Um paralelogramo, o canto inferior esquerdo no zero.</translation>
        </message>
        <message>
            <source>A piece of a ring about the zero, from X counter-clockwise.</source>
            <translation>Um pedaço de anel em torno do zero, a partir de X no sentido anti-horário.</translation>
        </message>
        <message>
            <source>A plate about the zero for a stepper motor of NEMA size 8, 11, 14, 17, 23 or 34.</source>
            <translation>Uma chapa em torno do zero para um motor de passo de tamanho NEMA 8, 11, 14, 17, 23 ou 34.</translation>
        </message>
        <message>
            <source>A plate about the zero with an eye and a hole at each of three corners.</source>
            <translation>Uma chapa em torno do zero com um olhal e um furo em cada um de três cantos.</translation>
        </message>
        <message>
            <source>A plate to hang a load: a base below, an eye about the zero above.</source>
            <translation>Uma chapa para pendurar uma carga: uma base embaixo, um olhal em torno do zero em cima.</translation>
        </message>
        <message>
            <source>A polygon of equal sides about the zero, one side below; the size is across the flats.</source>
            <translation>Um polígono de lados iguais em torno do zero, um lado embaixo; o tamanho é entre faces.</translation>
        </message>
        <message>
            <source>A rectangle about the zero with its corners cut off at 45°.</source>
            <translation>Um retângulo em torno do zero com os cantos cortados a 45°.</translation>
        </message>
        <message>
            <source>A rectangle about the zero, its corners sharp or round.</source>
            <translation>Um retângulo em torno do zero, de cantos vivos ou redondos.</translation>
        </message>
        <message>
            <source>A rectangular plate about the zero with a hole near each corner.</source>
            <translation>Uma chapa retangular em torno do zero com um furo perto de cada canto.</translation>
        </message>
        <message>
            <source>A right-angled stiffening plate, its right angle at the zero, cut off there to clear a weld.</source>
            <translation>Uma chapa de reforço em ângulo reto, o ângulo reto no zero, cortada ali para dar lugar à solda.</translation>
        </message>
        <message>
            <source>A ring, or a washer, about the zero.</source>
            <translation>Um anel, ou uma arruela, em torno do zero.</translation>
        </message>
        <message>
            <source>A round flange about the zero with a bore and a circle of bolt holes.</source>
            <translation>Um flange redondo em torno do zero com um furo central e um círculo de furos de parafusos.</translation>
        </message>
        <message>
            <source>A round hole with flat sides above and below, about the zero.</source>
            <translation>Um furo redondo com faces planas em cima e embaixo, em torno do zero.</translation>
        </message>
        <message>
            <source>A round hole with one flat side above, for shafts with a flat; about the circle's middle.</source>
            <translation>Um furo redondo com uma face plana em cima, para eixos com face plana; em torno do centro do círculo.</translation>
        </message>
        <message>
            <source>A shield, the zero in the middle of its upper edge: straight sides, round below.</source>
            <translation>Um escudo, o zero no meio da borda superior: lados retos, redondo embaixo.</translation>
        </message>
        <message>
            <source>A slice of a disc about the zero, from X counter-clockwise.</source>
            <translation>Uma fatia de disco em torno do zero, a partir de X no sentido anti-horário.</translation>
        </message>
        <message>
            <source>A slot in the edge of a plate for a bolt's head: open below, the zero at its mouth's middle.</source>
            <translation>Um rasgo na borda de uma chapa para a cabeça de um parafuso: aberto embaixo, o zero no meio da boca.</translation>
        </message>
        <message>
            <source>A slot with round ends along an arc about the zero, from X counter-clockwise.</source>
            <translation>Um rasgo de pontas redondas ao longo de um arco em torno do zero, a partir de X no sentido anti-horário.</translation>
        </message>
        <message>
            <source>A square plate about the zero with a bore and a hole near each corner.</source>
            <translation>Uma chapa quadrada em torno do zero com um furo central e um furo perto de cada canto.</translation>
        </message>
        <message>
            <source>A star about the zero, one point above.</source>
            <translation>Uma estrela em torno do zero, uma ponta em cima.</translation>
        </message>
        <message>
            <source>A straight slot with round ends along X, about the zero; the length is over all.</source>
            <translation>Um rasgo reto de pontas redondas ao longo de X, em torno do zero; o comprimento é o total.</translation>
        </message>
        <message>
            <source>A trapezoid, the zero in the middle of its base.</source>
            <translation>Um trapézio, o zero no meio da base.</translation>
        </message>
        <message>
            <source>A triangle with two equal sides, the zero in the middle of its base.</source>
            <translation>Um triângulo de dois lados iguais, o zero no meio da base.</translation>
        </message>
        <message>
            <source>A wheel about the zero with saw teeth and a bore.</source>
            <translation>Uma roda em torno do zero com dentes de serra e um furo.</translation>
        </message>
        <message>
            <source>ATAN needs a second value</source>
            <translation>ATAN precisa de um segundo valor</translation>
        </message>
        <message>
            <source>Across the flat</source>
            <translation>Até a face plana</translation>
        </message>
        <message>
            <source>Across the flats</source>
            <translation>Entre faces planas</translation>
        </message>
        <message>
            <source>Adobe Illustrator</source>
            <translation>Adobe Illustrator</translation>
        </message>
        <message>
            <source>An angle of two legs, its outer corner at the zero, a hole near the end of each leg.</source>
            <translation>Uma cantoneira de duas abas, o canto externo no zero, um furo perto da ponta de cada aba.</translation>
        </message>
        <message>
            <source>An arrow along X, its tip at the zero.</source>
            <translation>Uma seta ao longo de X, a ponta no zero.</translation>
        </message>
        <message>
            <source>Arc slot</source>
            <translation>Rasgo em arco</translation>
        </message>
        <message>
            <source>Bluetooth could not be started</source>
            <translation>o Bluetooth não pôde ser iniciado</translation>
        </message>
        <message>
            <source>Bore; 0: none</source>
            <translation>Furo central; 0: nenhum</translation>
        </message>
        <message>
            <source>CNCStepper batch journal</source>
            <translation>CNCStepper batch journal</translation>
        </message>
        <message>
            <source>CNCStepper certificate</source>
            <translation>certificado do CNCStepper</translation>
        </message>
        <message>
            <source>CNCStepper journal</source>
            <translation>CNCStepper journal</translation>
        </message>
        <message>
            <source>CNCStepper report</source>
            <translation>Relatório do CNCStepper</translation>
        </message>
        <message>
            <source>CadQuery or FreeCAD</source>
            <translation>CadQuery ou FreeCAD</translation>
        </message>
        <message>
            <source>CadQuery or build123d</source>
            <translation>CadQuery ou build123d</translation>
        </message>
        <message>
            <source>Chamfer along each side</source>
            <translation>Chanfro ao longo de cada lado</translation>
        </message>
        <message>
            <source>Chamfered rectangle</source>
            <translation>Retângulo chanfrado</translation>
        </message>
        <message>
            <source>Corner radius</source>
            <translation>Raio de canto</translation>
        </message>
        <message>
            <source>Cut off at the right angle</source>
            <translation>Corte no ângulo reto</translation>
        </message>
        <message>
            <source>D of {code} is the number of a tool</source>
            <translation>o D de {code} é o número de uma ferramenta</translation>
        </message>
        <message>
            <source>DejaVu Sans</source>
            <translation>DejaVu Sans</translation>
        </message>
        <message>
            <source>DejaVu Sans Mono</source>
            <translation>DejaVu Sans Mono</translation>
        </message>
        <message>
            <source>DejaVu Serif</source>
            <translation>DejaVu Serif</translation>
        </message>
        <message>
            <source>Diameter cut away</source>
            <translation>Diâmetro retirado</translation>
        </message>
        <message>
            <source>Diameter of its middle line</source>
            <translation>Diâmetro da linha média</translation>
        </message>
        <message>
            <source>Diameter of the bolt circle</source>
            <translation>Diâmetro do círculo de furos</translation>
        </message>
        <message>
            <source>Diameter of the disc</source>
            <translation>Diâmetro do disco</translation>
        </message>
        <message>
            <source>Diameter of the holes</source>
            <translation>Diâmetro dos furos</translation>
        </message>
        <message>
            <source>Diameter of the inner corners</source>
            <translation>Diâmetro dos cantos internos</translation>
        </message>
        <message>
            <source>Diameter of the notches</source>
            <translation>Diâmetro dos entalhes</translation>
        </message>
        <message>
            <source>Diameter of the points</source>
            <translation>Diâmetro das pontas</translation>
        </message>
        <message>
            <source>Diameter through the holes</source>
            <translation>Diâmetro pelos furos</translation>
        </message>
        <message>
            <source>Distance of both</source>
            <translation>Distância entre os dois</translation>
        </message>
        <message>
            <source>Distance of the holes</source>
            <translation>Distância entre os furos</translation>
        </message>
        <message>
            <source>Double D-hole</source>
            <translation>Furo em duplo D</translation>
        </message>
        <message>
            <source>Drag knife</source>
            <translation>Faca de arrasto</translation>
        </message>
        <message>
            <source>EXISTS asks for a parameter</source>
            <translation>EXISTS pergunta por um parâmetro</translation>
        </message>
        <message>
            <source>Ends of the legs</source>
            <translation>Pontas das abas</translation>
        </message>
        <message>
            <source>Eye plate</source>
            <translation>Chapa com olhal</translation>
        </message>
        <message>
            <source>First eye</source>
            <translation>Primeiro olhal</translation>
        </message>
        <message>
            <source>First hole</source>
            <translation>Primeiro furo</translation>
        </message>
        <message>
            <source>First hole at</source>
            <translation>Primeiro furo em</translation>
        </message>
        <message>
            <source>Flanges and plates</source>
            <translation>Flanges e chapas</translation>
        </message>
        <message>
            <source>FreeCAD has no stock of a height field</source>
            <translation>O FreeCAD não tem material bruto como campo de alturas</translation>
        </message>
        <message>
            <source>FreeCAD has no tool bit for a {tool_shape}</source>
            <translation>o FreeCAD não tem ferramenta para {tool_shape}</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {lacking}</source>
            <translation>Falta no Python do FreeCAD: {lacking}</translation>
        </message>
        <message>
            <source>From the base to the eye's middle</source>
            <translation>Da base ao centro do olhal</translation>
        </message>
        <message>
            <source>From the bore's bottom to the keyway's</source>
            <translation>Do fundo do furo ao fundo do rasgo</translation>
        </message>
        <message>
            <source>From the circle's middle to the slot's end</source>
            <translation>Do centro do círculo à ponta do rasgo</translation>
        </message>
        <message>
            <source>From the edges to the holes</source>
            <translation>Das bordas aos furos</translation>
        </message>
        <message>
            <source>From the middle to the point</source>
            <translation>Do centro à ponta</translation>
        </message>
        <message>
            <source>G10 L{kind} changes nothing</source>
            <translation>G10 L{kind} não muda nada</translation>
        </message>
        <message>
            <source>G10 is read with L1, L2, L10, L11 and L20 only</source>
            <translation>G10 só é lido com L1, L2, L10, L11 e L20</translation>
        </message>
        <message>
            <source>G28 and G30 may not be used</source>
            <translation>G28 e G30 não podem ser usados</translation>
        </message>
        <message>
            <source>G28 homes a Marlin machine: home it before the program</source>
            <translation>G28 referencia uma máquina com Marlin: referencie-a antes do programa</translation>
        </message>
        <message>
            <source>G28.1 homes a Mach machine: home it before the program</source>
            <translation>G28.1 referencia uma máquina com Mach: referencie-a antes do programa</translation>
        </message>
        <message>
            <source>G43.1 may move only the tool-length axis</source>
            <translation>G43.1 só pode mover o eixo do comprimento da ferramenta</translation>
        </message>
        <message>
            <source>G43.2 takes H, and a line with it takes no axis words</source>
            <translation>G43.2 usa H, e uma linha com ele não aceita palavras de eixo</translation>
        </message>
        <message>
            <source>G5 needs both I and J or neither</source>
            <translation>G5 precisa de I e J ou de nenhum dos dois</translation>
        </message>
        <message>
            <source>G5 needs both P and Q</source>
            <translation>G5 precisa de P e Q</translation>
        </message>
        <message>
            <source>G5.3 ends a NURBS: no other motion may share its line</source>
            <translation>G5.3 termina uma NURBS: nenhum outro movimento pode ficar na mesma linha</translation>
        </message>
        <message>
            <source>G5.3 without a G5.2 before it</source>
            <translation>G5.3 termina o que nenhum G5.2 começou</translation>
        </message>
        <message>
            <source>G52 moves the zero about which the path is changed</source>
            <translation>G52 move o zero em torno do qual o percurso é alterado</translation>
        </message>
        <message>
            <source>G53 and G28 have no place in work coordinates: give the work zero, or take them out</source>
            <translation>G53 e G28 não têm lugar em coordenadas da peça: informe o zero-peça ou retire-os</translation>
        </message>
        <message>
            <source>G53 may not be used</source>
            <translation>G53 não pode ser usado</translation>
        </message>
        <message>
            <source>G53 needs a G0 or G1 move</source>
            <translation>G53 precisa de um movimento G0 ou G1</translation>
        </message>
        <message>
            <source>G53 takes X and Y only</source>
            <translation>G53 só aceita X e Y</translation>
        </message>
        <message>
            <source>G53 takes absolute coordinates only</source>
            <translation>G53 só aceita coordenadas absolutas</translation>
        </message>
        <message>
            <source>G53 works only with G0 and G1</source>
            <translation>G53 só funciona com G0 e G1</translation>
        </message>
        <message>
            <source>G64 P lets the machine cut corners: times and pulses do so, the simulated part shows the programmed path</source>
            <translation>G64 P deixa a máquina cortar cantos: os tempos e os pulsos os cortam, a peça simulada mostra o caminho programado</translation>
        </message>
        <message>
            <source>G64 without P does not say how far the machine may cut corners; all is worked out for the programmed path</source>
            <translation>G64 sem P não diz quanto a máquina pode cortar os cantos; tudo é calculado para o caminho programado</translation>
        </message>
        <message>
            <source>G76 moves X and Z only</source>
            <translation>G76 só move X e Z</translation>
        </message>
        <message>
            <source>G80 leaves no motion for the axis words</source>
            <translation>G80 não deixa movimento para as palavras de eixo</translation>
        </message>
        <message>
            <source>Height below the notch</source>
            <translation>Altura abaixo do entalhe</translation>
        </message>
        <message>
            <source>Height of the head</source>
            <translation>Altura da cabeça</translation>
        </message>
        <message>
            <source>Height of the plate above the middle</source>
            <translation>Altura da chapa acima do centro</translation>
        </message>
        <message>
            <source>Height of the teeth</source>
            <translation>Altura dos dentes</translation>
        </message>
        <message>
            <source>Hole for the head</source>
            <translation>Furo para a cabeça</translation>
        </message>
        <message>
            <source>Holes; 0: none</source>
            <translation>Furos; 0: nenhum</translation>
        </message>
        <message>
            <source>Hot wire</source>
            <translation>Fio quente</translation>
        </message>
        <message>
            <source>I of G76 may not be 0</source>
            <translation>o I de G76 não pode ser 0</translation>
        </message>
        <message>
            <source>I of {name} must be above 0</source>
            <translation>o I de {name} deve ser maior que 0</translation>
        </message>
        <message>
            <source>I, J and K are given from the start point of the arc</source>
            <translation>I, J e K são dados a partir do ponto inicial do arco</translation>
        </message>
        <message>
            <source>IJK distance mode changed to absolute</source>
            <translation>modo de distância de IJK mudado para absoluto</translation>
        </message>
        <message>
            <source>IJK distance mode changed to incremental</source>
            <translation>modo de distância de IJK mudado para incremental</translation>
        </message>
        <message>
            <source>ISO 6983 has no such word: leave it out</source>
            <translation>a ISO 6983 não tem essa palavra: omita-a</translation>
        </message>
        <message>
            <source>Inner diameter</source>
            <translation>Diâmetro interno</translation>
        </message>
        <message>
            <source>Inside of the hook</source>
            <translation>Interior do gancho</translation>
        </message>
        <message>
            <source>Isosceles triangle</source>
            <translation>Triângulo isósceles</translation>
        </message>
        <message>
            <source>J and R make too many passes</source>
            <translation>J e R resultam em passes demais</translation>
        </message>
        <message>
            <source>J of G76 must be above 0</source>
            <translation>o J de G76 deve ser maior que 0</translation>
        </message>
        <message>
            <source>K of G76 must be above J</source>
            <translation>o K de G76 deve ser maior que J</translation>
        </message>
        <message>
            <source>Kerf test: S = {0} mm, kerf used {1} mm. {2}</source>
            <translation>Teste da largura do corte: S = {0} mm, largura usada {1} mm. {2}</translation>
        </message>
        <message>
            <source>Keyway bore</source>
            <translation>Furo com chaveta</translation>
        </message>
        <message>
            <source>L may not be negative</source>
            <translation>L não pode ser negativo</translation>
        </message>
        <message>
            <source>Length of the head</source>
            <translation>Comprimento da cabeça</translation>
        </message>
        <message>
            <source>Length of the neck</source>
            <translation>Comprimento do pescoço</translation>
        </message>
        <message>
            <source>Liberation Mono</source>
            <translation>Liberation Mono</translation>
        </message>
        <message>
            <source>Liberation Sans</source>
            <translation>Liberation Sans</translation>
        </message>
        <message>
            <source>Liberation Serif</source>
            <translation>Liberation Serif</translation>
        </message>
        <message>
            <source>LinuxCNC with QtPlasmaC</source>
            <translation>LinuxCNC com QtPlasmaC</translation>
        </message>
        <message>
            <source>Locking wheel</source>
            <translation>Roda de trava</translation>
        </message>
        <message>
            <source>M3 starts one tool</source>
            <translation>M3 liga uma só ferramenta</translation>
        </message>
        <message>
            <source>M6 depends on the machine's configuration: pause with M0, or split at tool changes</source>
            <translation>M6 depende da configuração da máquina: faça uma pausa com M0 ou divida o programa nas trocas de ferramenta</translation>
        </message>
        <message>
            <source>M66 takes either P, a digital input, or E, an analogue one</source>
            <translation>M66 aceita P, uma entrada digital, ou E, uma analógica</translation>
        </message>
        <message>
            <source>M66 with L waits: it needs Q above 0</source>
            <translation>M66 com L espera: precisa de Q maior que 0</translation>
        </message>
        <message>
            <source>M98 needs a P word</source>
            <translation>M98 precisa de uma palavra P</translation>
        </message>
        <message>
            <source>M98 takes one P and one L</source>
            <translation>M98 aceita um P e um L</translation>
        </message>
        <message>
            <source>Mach probes with G31</source>
            <translation>o Mach apalpa com G31</translation>
        </message>
        <message>
            <source>Machine profile, made by CNCStepper</source>
            <translation>Perfil de máquina, feito pelo CNCStepper</translation>
        </message>
        <message>
            <source>Margin around the motor</source>
            <translation>Margem em torno do motor</translation>
        </message>
        <message>
            <source>Marlin has no end word (M30 deletes a file): leave it out</source>
            <translation>o Marlin não tem palavra de fim (M30 apaga um arquivo): omita-a</translation>
        </message>
        <message>
            <source>Marlin means something else with it</source>
            <translation>para o Marlin isso significa outra coisa</translation>
        </message>
        <message>
            <source>Marlin would read G91 or G90: leave it out</source>
            <translation>o Marlin leria G91 ou G90: omita-a</translation>
        </message>
        <message>
            <source>Mounting plate</source>
            <translation>Chapa de montagem</translation>
        </message>
        <message>
            <source>NEMA motor plate</source>
            <translation>Chapa para motor NEMA</translation>
        </message>
        <message>
            <source>NEMA size</source>
            <translation>Tamanho NEMA</translation>
        </message>
        <message>
            <source>NOT simulated on a stock: the machine's limits are checked, but not whether a rapid meets material; give --job, or --stock and --tool</source>
            <translation>NÃO cortado em nenhum material: os limites da máquina são verificados, mas ninguém vê se um avanço rápido encontra material; dê --job, ou --stock e --tool</translation>
        </message>
        <message>
            <source>Nested parts</source>
            <translation>Peças aninhadas</translation>
        </message>
        <message>
            <source>Nimbus Mono PS</source>
            <translation>Nimbus Mono PS</translation>
        </message>
        <message>
            <source>Nimbus Roman</source>
            <translation>Nimbus Roman</translation>
        </message>
        <message>
            <source>Nimbus Sans</source>
            <translation>Nimbus Sans</translation>
        </message>
        <message>
            <source>O-words are nested too deeply</source>
            <translation>há palavras O aninhadas demais</translation>
        </message>
        <message>
            <source>O-words work only in a macro of the controller</source>
            <translation>palavras O só funcionam em uma macro do controlador</translation>
        </message>
        <message>
            <source>O-words work only in a macro on the controller's card</source>
            <translation>palavras O só funcionam em uma macro no cartão do controlador</translation>
        </message>
        <message>
            <source>O1234 ends with M99</source>
            <translation>O1234 termina com M99</translation>
        </message>
        <message>
            <source>O1234 is called by M98 P1234</source>
            <translation>O1234 é chamado por M98 P1234</translation>
        </message>
        <message>
            <source>Outer diameter</source>
            <translation>Diâmetro externo</translation>
        </message>
        <message>
            <source>Oval flange</source>
            <translation>Flange oval</translation>
        </message>
        <message>
            <source>P of G04 is seconds on some controls and milliseconds on others</source>
            <translation>o P de G04 são segundos em alguns comandos e milissegundos em outros</translation>
        </message>
        <message>
            <source>PID eq {0}</source>
            <translation>PID eq {0}</translation>
        </message>
        <message>
            <source>Parts and signs</source>
            <translation>Peças e placas</translation>
        </message>
        <message>
            <source>Q asks for too many pecks</source>
            <translation>Q pede picadas demais</translation>
        </message>
        <message>
            <source>Q of M19 must be above 0</source>
            <translation>o Q de M19 deve ser maior que 0</translation>
        </message>
        <message>
            <source>QtPlasmaC changes feed and end of small holes itself: that is not in this reading</source>
            <translation>o QtPlasmaC muda por conta própria o avanço e o fim de furos pequenos: isso não está nesta leitura</translation>
        </message>
        <message>
            <source>QtPlasmaC cuts a tube, with the program's own moves of Z: they are not in this reading</source>
            <translation>o QtPlasmaC corta um tubo, com os movimentos de Z do próprio programa: eles não estão nesta leitura</translation>
        </message>
        <message>
            <source>QtPlasmaC has no key {key}</source>
            <translation>o QtPlasmaC não tem a chave {key}</translation>
        </message>
        <message>
            <source>QtPlasmaC keeps the program's own moves of Z: they are not in this reading</source>
            <translation>o QtPlasmaC mantém os movimentos de Z do próprio programa: eles não estão nesta leitura</translation>
        </message>
        <message>
            <source>QtPlasmaC moves Z itself: arcs are in XY</source>
            <translation>o QtPlasmaC move o Z por conta própria: arcos são em XY</translation>
        </message>
        <message>
            <source>QtPlasmaC pierces only and cuts nothing: that is not in this reading</source>
            <translation>o QtPlasmaC só perfura e não corta nada: isso não está nesta leitura</translation>
        </message>
        <message>
            <source>R lies below {normal}</source>
            <translation>R fica abaixo de {normal}</translation>
        </message>
        <message>
            <source>Radius of the inner corner</source>
            <translation>Raio do canto interno</translation>
        </message>
        <message>
            <source>Radius of the inner corners</source>
            <translation>Raio dos cantos internos</translation>
        </message>
        <message>
            <source>Ratchet wheel</source>
            <translation>Roda de catraca</translation>
        </message>
        <message>
            <source>Regular polygon</source>
            <translation>Polígono regular</translation>
        </message>
        <message>
            <source>Reset to continue</source>
            <translation>Reset to continue</translation>
        </message>
        <message>
            <source>Ring sector</source>
            <translation>Setor de anel</translation>
        </message>
        <message>
            <source>Round shapes</source>
            <translation>Formas redondas</translation>
        </message>
        <message>
            <source>SIGTERM lets its process stop the machine safely</source>
            <translation>SIGTERM faz o processo parar a máquina com segurança</translation>
        </message>
        <message>
            <source>Second eye</source>
            <translation>Segundo olhal</translation>
        </message>
        <message>
            <source>Second hole</source>
            <translation>Segundo furo</translation>
        </message>
        <message>
            <source>SetThreadExecutionState was refused</source>
            <translation>SetThreadExecutionState foi recusado</translation>
        </message>
        <message>
            <source>Slots and holes</source>
            <translation>Rasgos e furos</translation>
        </message>
        <message>
            <source>Speed test {0} of {1}: {2} mm/min, {3} %</source>
            <translation>Teste de velocidade {0} de {1}: {2} mm/min, {3} %</translation>
        </message>
        <message>
            <source>Square flange</source>
            <translation>Flange quadrado</translation>
        </message>
        <message>
            <source>T selects an extruder: pause with M0 where the tool is to be changed</source>
            <translation>T seleciona um extrusor: faça uma pausa com M0 onde a ferramenta deve ser trocada</translation>
        </message>
        <message>
            <source>TLS takes an authority, a certificate and its key</source>
            <translation>TLS exige uma autoridade, um certificado e a chave dele</translation>
        </message>
        <message>
            <source>The section of a beam, about the zero.</source>
            <translation>A seção de uma viga, em torno do zero.</translation>
        </message>
        <message>
            <source>Thickness of the flanges</source>
            <translation>Espessura das mesas</translation>
        </message>
        <message>
            <source>Thickness of the web</source>
            <translation>Espessura da alma</translation>
        </message>
        <message>
            <source>Times New Roman</source>
            <translation>Times New Roman</translation>
        </message>
        <message>
            <source>Trial {0} pulses/s late mean {1} us worst {2} us</source>
            <translation>Ensaio {0} pulsos/s atraso médio {1} us pior {2} us</translation>
        </message>
        <message>
            <source>Triangular plate</source>
            <translation>Chapa triangular</translation>
        </message>
        <message>
            <source>Twice from the middle to a side</source>
            <translation>Duas vezes do centro a um lado</translation>
        </message>
        <message>
            <source>Two eyes and the bar that joins them along X; the first eye's hole is at the zero.</source>
            <translation>Dois olhais e a barra que os une ao longo de X; o furo do primeiro olhal está no zero.</translation>
        </message>
        <message>
            <source>Two flanges that an offset web joins, its left lower corner at the zero; a hole in each flange.</source>
            <translation>Duas abas unidas por uma alma deslocada, o canto inferior esquerdo no zero; um furo em cada aba.</translation>
        </message>
        <message>
            <source>Two legs up from a base, the zero in the middle of the base's lower edge; a hole in each leg.</source>
            <translation>Duas abas acima de uma base, o zero no meio da borda inferior da base; um furo em cada aba.</translation>
        </message>
        <message>
            <source>Water jet</source>
            <translation>Jato de água</translation>
        </message>
        <message>
            <source>Width of each flange</source>
            <translation>Largura de cada aba</translation>
        </message>
        <message>
            <source>Width of the bar</source>
            <translation>Largura da barra</translation>
        </message>
        <message>
            <source>Width of the bars</source>
            <translation>Largura das barras</translation>
        </message>
        <message>
            <source>Width of the ears</source>
            <translation>Largura das orelhas</translation>
        </message>
        <message>
            <source>Width of the head</source>
            <translation>Largura da cabeça</translation>
        </message>
        <message>
            <source>Width of the key</source>
            <translation>Largura da chaveta</translation>
        </message>
        <message>
            <source>Width of the legs</source>
            <translation>Largura das abas</translation>
        </message>
        <message>
            <source>Width of the mouth</source>
            <translation>Largura da boca</translation>
        </message>
        <message>
            <source>Width of the shaft</source>
            <translation>Largura da haste</translation>
        </message>
        <message>
            <source>Width of the slot</source>
            <translation>Largura do rasgo</translation>
        </message>
        <message>
            <source>X goes past the centre</source>
            <translation>X passa do centro</translation>
        </message>
        <message>
            <source>X is the {0}</source>
            <translation>X é o {0}</translation>
        </message>
        <message>
            <source>[ is missing after {keyword}</source>
            <translation>falta [ depois de {keyword}</translation>
        </message>
        <message>
            <source>`$` lists what the controller knows</source>
            <translation>`$` lista o que o controlador conhece</translation>
        </message>
        <message>
            <source>`cncstepper check` checks a program without the machine</source>
            <translation>`cncstepper check` verifica um programa sem a máquina</translation>
        </message>
        <message>
            <source>`kill {process}` (SIGTERM) lets its process stop the machine safely</source>
            <translation>`kill {process}` (SIGTERM) faz o processo parar a máquina com segurança</translation>
        </message>
        <message>
            <source>a G code has one decimal at most</source>
            <translation>um código G tem no máximo uma casa decimal</translation>
        </message>
        <message>
            <source>a G92 is in force where the tool is changed: a new program cannot rely on it</source>
            <translation>um G92 está em vigor onde a ferramenta é trocada: um novo programa não pode contar com ele</translation>
        </message>
        <message>
            <source>a JSON of the first release, and too large</source>
            <translation>um JSON da primeira versão, e grande demais</translation>
        </message>
        <message>
            <source>a NURBS of order {order} needs as many control points</source>
            <translation>uma NURBS de ordem {order} precisa do mesmo número de pontos de controle</translation>
        </message>
        <message>
            <source>a P or L value is missing</source>
            <translation>falta um valor P ou L</translation>
        </message>
        <message>
            <source>a `%` is neither at the begin nor at the end of the file</source>
            <translation>há um `%` onde nenhum arquivo começa nem termina</translation>
        </message>
        <message>
            <source>a bar of {diameter:g} x {length:g} mm holds no material</source>
            <translation>uma barra de {diameter:g} x {length:g} mm não contém material</translation>
        </message>
        <message>
            <source>a bulge is not that of an arc in mm</source>
            <translation>um bulge não é o de um arco em mm</translation>
        </message>
        <message>
            <source>a canned cycle moves X, Y and Z only</source>
            <translation>um ciclo fixo só move X, Y e Z</translation>
        </message>
        <message>
            <source>a canned cycle takes no inverse time feed</source>
            <translation>um ciclo fixo não aceita avanço em tempo inverso</translation>
        </message>
        <message>
            <source>a chip load needs flutes</source>
            <translation>um avanço por dente precisa do número de dentes</translation>
        </message>
        <message>
            <source>a collection of {0} faces</source>
            <translation>uma coleção de {0} fontes</translation>
        </message>
        <message>
            <source>a comment is closed that was not opened</source>
            <translation>é fechado um comentário que não foi aberto</translation>
        </message>
        <message>
            <source>a comment may not hold another one</source>
            <translation>um comentário não pode conter outro</translation>
        </message>
        <message>
            <source>a control pin was active at start</source>
            <translation>um pino de controle estava ativo na partida</translation>
        </message>
        <message>
            <source>a control point needs a weight P above 0</source>
            <translation>um ponto de controle precisa de um peso P maior que 0</translation>
        </message>
        <message>
            <source>a control point needs both X and Y</source>
            <translation>um ponto de controle precisa de X e Y</translation>
        </message>
        <message>
            <source>a controller with a firmware of its own</source>
            <translation>um controlador com firmware próprio</translation>
        </message>
        <message>
            <source>a coordinate is not a length in mm</source>
            <translation>uma coordenada não é um comprimento em mm</translation>
        </message>
        <message>
            <source>a corner has a chamfer_mm or a fillet_mm, not both</source>
            <translation>um canto tem chamfer_mm ou fillet_mm, não ambos</translation>
        </message>
        <message>
            <source>a corner is either rounded (A) or broken (C)</source>
            <translation>um canto é arredondado (A) ou chanfrado (C)</translation>
        </message>
        <message>
            <source>a corner of the mesh is no number</source>
            <translation>um vértice da malha não é um número</translation>
        </message>
        <message>
            <source>a corner of the mesh is no number in bounds</source>
            <translation>um vértice da malha não é um número dentro dos limites</translation>
        </message>
        <message>
            <source>a corner of the profile is too small for its fillet or chamfer</source>
            <translation>um canto do perfil é pequeno demais para o seu arredondamento ou chanfro</translation>
        </message>
        <message>
            <source>a corner radius of {radius:g} mm is too large for a side</source>
            <translation>um raio de canto de {radius:g} mm é grande demais para um lado</translation>
        </message>
        <message>
            <source>a curve needs at least two points and a bulge for each segment</source>
            <translation>uma curva precisa de ao menos dois pontos e de um bulge por segmento</translation>
        </message>
        <message>
            <source>a cut chart holds [[cut]] tables and nothing else</source>
            <translation>uma tabela de corte contém tabelas [[cut]] e nada mais</translation>
        </message>
        <message>
            <source>a cut goes into stock while the spindle is off</source>
            <translation>um corte entra no material com o spindle parado</translation>
        </message>
        <message>
            <source>a cut of the arranged program lies elsewhere, or has another feed, spindle or tool</source>
            <translation>um corte do programa disposto está em outro lugar ou tem outro avanço, outra rotação ou outra ferramenta</translation>
        </message>
        <message>
            <source>a cutting move begins at an unknown position, so it is not checked against the stock</source>
            <translation>um movimento de corte começa em posição desconhecida, por isso não é verificado contra o bloco</translation>
        </message>
        <message>
            <source>a cutting move has no feed</source>
            <translation>um movimento de corte não tem avanço</translation>
        </message>
        <message>
            <source>a cutting move has no feed rate</source>
            <translation>um movimento de corte não tem avanço</translation>
        </message>
        <message>
            <source>a cylinder is as long in X as in Y</source>
            <translation>um cilindro é tão comprido em X quanto em Y</translation>
        </message>
        <message>
            <source>a device on the Modbus does not answer as it should</source>
            <translation>um dispositivo no Modbus não responde como devia</translation>
        </message>
        <message>
            <source>a difference of {slack:.4f} mm</source>
            <translation>uma diferença de {slack:.4f} mm</translation>
        </message>
        <message>
            <source>a distance must be a number</source>
            <translation>uma distância tem de ser um número</translation>
        </message>
        <message>
            <source>a dog-bone would be too long</source>
            <translation>um alívio de canto ficaria longo demais</translation>
        </message>
        <message>
            <source>a drawing of that name is there already</source>
            <translation>já existe um desenho com esse nome</translation>
        </message>
        <message>
            <source>a drawing's unit lies between a nanometre and a kilometre</source>
            <translation>a unidade de um desenho fica entre um nanômetro e um quilômetro</translation>
        </message>
        <message>
            <source>a drill cannot cut along a contour</source>
            <translation>uma broca não pode cortar ao longo de um contorno</translation>
        </message>
        <message>
            <source>a drill goes sideways through stock</source>
            <translation>uma broca anda de lado dentro do material</translation>
        </message>
        <message>
            <source>a fault of the program: {kind}: {error}</source>
            <translation>uma falha do programa: {kind}: {error}</translation>
        </message>
        <message>
            <source>a feed of inverse time (G93) cannot stay where the axes are scaled differently</source>
            <translation>um avanço em tempo inverso (G93) não pode ficar onde os eixos têm escalas diferentes</translation>
        </message>
        <message>
            <source>a feed per revolution needs a speed of the spindle</source>
            <translation>um avanço por volta precisa de uma rotação do fuso</translation>
        </message>
        <message>
            <source>a feed would become 0</source>
            <translation>um avanço passaria a ser 0</translation>
        </message>
        <message>
            <source>a file that calls this machine's position unknown belongs to {user} and cannot be opened</source>
            <translation>um arquivo que dá a posição desta máquina como desconhecida pertence a {user} e não pode ser aberto</translation>
        </message>
        <message>
            <source>a glyph calls too many subroutines</source>
            <translation>um glifo chama sub-rotinas demais</translation>
        </message>
        <message>
            <source>a glyph has too many parts</source>
            <translation>um glifo tem partes demais</translation>
        </message>
        <message>
            <source>a glyph has too many segments</source>
            <translation>um glifo tem segmentos demais</translation>
        </message>
        <message>
            <source>a height field needs two rows and two columns of finite heights at least</source>
            <translation>um campo de alturas precisa de ao menos duas linhas e duas colunas de alturas finitas</translation>
        </message>
        <message>
            <source>a helix needs a known start point</source>
            <translation>uma hélice precisa de um ponto inicial conhecido</translation>
        </message>
        <message>
            <source>a hole lies in no outline</source>
            <translation>um furo não fica dentro de nenhum contorno</translation>
        </message>
        <message>
            <source>a hole would reach beyond its outline</source>
            <translation>um furo passaria do contorno</translation>
        </message>
        <message>
            <source>a hundred turns are enough</source>
            <translation>cem voltas bastam</translation>
        </message>
        <message>
            <source>a job runs</source>
            <translation>um trabalho está em curso</translation>
        </message>
        <message>
            <source>a job runs, and the machine is not at standstill</source>
            <translation>um trabalho está em andamento, e a máquina não está parada</translation>
        </message>
        <message>
            <source>a jog needs a way and a feed</source>
            <translation>um movimento manual precisa de distância e avanço</translation>
        </message>
        <message>
            <source>a lathe has no cycle '{name}'</source>
            <translation>um torno não tem o ciclo '{name}'</translation>
        </message>
        <message>
            <source>a lathe tool is compensated in the plane ZX</source>
            <translation>uma ferramenta de torno é compensada no plano ZX</translation>
        </message>
        <message>
            <source>a lead of kind 'arc' needs radius_mm, and no length_mm</source>
            <translation>uma entrada ou saída do tipo 'arc' precisa de radius_mm e não de length_mm</translation>
        </message>
        <message>
            <source>a lead of kind 'line' needs length_mm, and no radius_mm</source>
            <translation>uma entrada ou saída do tipo 'line' precisa de length_mm e não de radius_mm</translation>
        </message>
        <message>
            <source>a lead or a cut goes through a part</source>
            <translation>uma entrada ou um corte atravessa uma peça</translation>
        </message>
        <message>
            <source>a limit or door is on a pin with a number, without port: on the machine's own</source>
            <translation>um fim de curso ou porta de segurança fica num pino com número e sem porta: na porta da própria máquina</translation>
        </message>
        <message>
            <source>a limit switch is pressed</source>
            <translation>um fim de curso está acionado</translation>
        </message>
        <message>
            <source>a limit switch is pressed; only homing is allowed</source>
            <translation>um fim de curso está acionado; só o referenciamento é permitido</translation>
        </message>
        <message>
            <source>a limit switch stayed pressed after homing</source>
            <translation>um fim de curso ficou acionado depois do referenciamento</translation>
        </message>
        <message>
            <source>a limit switch was hit</source>
            <translation>um fim de curso foi atingido</translation>
        </message>
        <message>
            <source>a limit switch was hit while probing</source>
            <translation>um fim de curso foi atingido durante a apalpação</translation>
        </message>
        <message>
            <source>a limit switch was pressed before homing, and which one is not clear</source>
            <translation>um fim de curso estava acionado antes do referenciamento, e não se sabe qual</translation>
        </message>
        <message>
            <source>a line does not fit the controller's buffer</source>
            <translation>uma linha não cabe no buffer do controlador</translation>
        </message>
        <message>
            <source>a line holds one command</source>
            <translation>uma linha contém um só comando</translation>
        </message>
        <message>
            <source>a line holds {count} M codes</source>
            <translation>uma linha contém {count} códigos M</translation>
        </message>
        <message>
            <source>a line in '{label}' is open and encloses nothing</source>
            <translation>uma linha em '{label}' está aberta e não encerra nada</translation>
        </message>
        <message>
            <source>a line is too long</source>
            <translation>uma linha é comprida demais</translation>
        </message>
        <message>
            <source>a line needs at least two different points</source>
            <translation>uma linha precisa de pelo menos dois pontos diferentes</translation>
        </message>
        <message>
            <source>a line number begins with a digit</source>
            <translation>um número de linha começa com um algarismo</translation>
        </message>
        <message>
            <source>a line number is written in digits</source>
            <translation>um número de linha é escrito com algarismos</translation>
        </message>
        <message>
            <source>a line of a parameter file is the number of a parameter and its value</source>
            <translation>cada linha de um arquivo de parâmetros é o número de um parâmetro e o seu valor</translation>
        </message>
        <message>
            <source>a line of a tool table names one tool, and no other line names it</source>
            <translation>uma linha da tabela de ferramentas indica uma ferramenta, que aparece nela uma só vez</translation>
        </message>
        <message>
            <source>a line that begins with $ is a setting or command for the controller, not part of a program</source>
            <translation>uma linha que começa com $ é um ajuste ou comando para o controlador, não faz parte de um programa</translation>
        </message>
        <message>
            <source>a line that changes the tool does more than that</source>
            <translation>uma linha que troca a ferramenta faz mais do que isso</translation>
        </message>
        <message>
            <source>a line that runs at every start moves the machine while nobody watches</source>
            <translation>uma linha que roda sozinha a cada partida move a máquina sem ninguém olhando</translation>
        </message>
        <message>
            <source>a line with G80 takes no axis words, nor those of G43.1</source>
            <translation>uma linha com G80 não aceita palavras de eixo, nem as de G43.1</translation>
        </message>
        <message>
            <source>a list has no entry {0}</source>
            <translation>uma lista não tem o item {0}</translation>
        </message>
        <message>
            <source>a list of glyphs is longer than its table</source>
            <translation>uma lista de glifos é mais longa que a sua tabela</translation>
        </message>
        <message>
            <source>a machine is cutting</source>
            <translation>uma máquina está cortando</translation>
        </message>
        <message>
            <source>a macro has stopped with an error of its own</source>
            <translation>uma macro parou com um erro próprio</translation>
        </message>
        <message>
            <source>a margin of {margin_mm:.3g} mm</source>
            <translation>uma margem de {margin_mm:.3g} mm</translation>
        </message>
        <message>
            <source>a material file has no {key}: left out</source>
            <translation>um arquivo de materiais não tem {key}: omitido</translation>
        </message>
        <message>
            <source>a material file holds no rows of {process}</source>
            <translation>um arquivo de materiais não contém linhas de {process}</translation>
        </message>
        <message>
            <source>a material number is used twice</source>
            <translation>um número de material aparece duas vezes</translation>
        </message>
        <message>
            <source>a mesh and no line</source>
            <translation>uma malha e não uma linha</translation>
        </message>
        <message>
            <source>a message could not be sent</source>
            <translation>uma mensagem não pôde ser enviada</translation>
        </message>
        <message>
            <source>a mill that does not cut over its centre ({tool}) goes down into stock too steeply</source>
            <translation>uma fresa sem corte no centro ({tool}) desce no material com inclinação demais</translation>
        </message>
        <message>
            <source>a motor driver reports a fault</source>
            <translation>um driver de motor acusa falha</translation>
        </message>
        <message>
            <source>a move would end outside the travel (soft limit)</source>
            <translation>um movimento terminaria fora do curso (limite de software)</translation>
        </message>
        <message>
            <source>a number beyond {most:g}: {text}</source>
            <translation>um número além de {most:g}: {text}</translation>
        </message>
        <message>
            <source>a number beyond {most_count}: {text}</source>
            <translation>um número além de {most_count}: {text}</translation>
        </message>
        <message>
            <source>a number is missing or cannot be read</source>
            <translation>um número falta ou não pode ser lido</translation>
        </message>
        <message>
            <source>a number is out of range</source>
            <translation>um número está fora dos limites</translation>
        </message>
        <message>
            <source>a number of hundreds of digits</source>
            <translation>um número de centenas de algarismos</translation>
        </message>
        <message>
            <source>a number of the table is too long</source>
            <translation>um número da tabela é longo demais</translation>
        </message>
        <message>
            <source>a number of thousands of digits</source>
            <translation>um número de milhares de algarismos</translation>
        </message>
        <message>
            <source>a number that names something is short</source>
            <translation>um número que dá nome a algo é curto</translation>
        </message>
        <message>
            <source>a number that no letter begins</source>
            <translation>um número sem letra antes dele</translation>
        </message>
        <message>
            <source>a parallel port has 25 pins, and one below zero is active low</source>
            <translation>uma porta paralela tem 25 pinos, e um abaixo de zero é ativo em nível baixo</translation>
        </message>
        <message>
            <source>a parameter could not be set</source>
            <translation>um parâmetro não pôde ser definido</translation>
        </message>
        <message>
            <source>a part must have a length</source>
            <translation>um trecho tem de ter comprimento</translation>
        </message>
        <message>
            <source>a part of another operation</source>
            <translation>uma peça de outra operação</translation>
        </message>
        <message>
            <source>a path has no length, or a coordinate that is no length in mm</source>
            <translation>um caminho não tem comprimento ou tem uma coordenada que não é um comprimento em mm</translation>
        </message>
        <message>
            <source>a path is mirrored along X or Y</source>
            <translation>um percurso é espelhado em X ou Y</translation>
        </message>
        <message>
            <source>a path is too long for its tolerance</source>
            <translation>um caminho é longo demais para a sua tolerância</translation>
        </message>
        <message>
            <source>a pattern has at most {0} characters</source>
            <translation>um padrão tem no máximo {0} caracteres</translation>
        </message>
        <message>
            <source>a picture and no line</source>
            <translation>uma imagem, e não uma linha</translation>
        </message>
        <message>
            <source>a piece {length:.3f} mm long comes off the bar here</source>
            <translation>aqui uma peça de {length:.3f} mm de comprimento se separa da barra</translation>
        </message>
        <message>
            <source>a pin in the configuration is wrong</source>
            <translation>um pino da configuração está errado</translation>
        </message>
        <message>
            <source>a pin with a number has a port: the device file of its parallel port</source>
            <translation>um pino com número tem uma porta: o arquivo de dispositivo da sua porta paralela</translation>
        </message>
        <message>
            <source>a pipe (FIFO)</source>
            <translation>um pipe (FIFO)</translation>
        </message>
        <message>
            <source>a place before the begin of a table</source>
            <translation>um lugar antes do início de uma tabela</translation>
        </message>
        <message>
            <source>a point is too far away</source>
            <translation>um ponto está longe demais</translation>
        </message>
        <message>
            <source>a probe or an input sets it on the machine</source>
            <translation>um apalpador ou uma entrada o define na máquina</translation>
        </message>
        <message>
            <source>a probe takes no feed per turn</source>
            <translation>uma apalpação não aceita avanço por rotação</translation>
        </message>
        <message>
            <source>a process of our own cannot be started</source>
            <translation>um processo nosso não pode ser iniciado</translation>
        </message>
        <message>
            <source>a process of ours has a machine's port, but its file {path} cannot be read: {error}</source>
            <translation>um processo nosso tem a porta de uma máquina, mas seu arquivo {path} não pode ser lido: {error}</translation>
        </message>
        <message>
            <source>a profile needs points or dxf, one of them</source>
            <translation>um perfil precisa de points ou dxf, um dos dois</translation>
        </message>
        <message>
            <source>a profile's ends have no corner to cut and its begin no arc</source>
            <translation>as pontas de um perfil não têm canto a cortar, e o início não tem arco</translation>
        </message>
        <message>
            <source>a program for {language} cannot be restarted in its middle</source>
            <translation>um programa para {language} não pode ser retomado no meio</translation>
        </message>
        <message>
            <source>a program of the mini-lathe begins at the work zero and cannot be entered in its middle</source>
            <translation>um programa do minitorno começa no zero da peça e não pode ser retomado no meio</translation>
        </message>
        <message>
            <source>a program on the controller stopped at an error</source>
            <translation>um programa no controlador parou em um erro</translation>
        </message>
        <message>
            <source>a program that goes to machine positions cannot be placed beside others</source>
            <translation>um programa que vai a posições de máquina não pode ser colocado ao lado de outros</translation>
        </message>
        <message>
            <source>a program that sets or chooses a work offset cannot be placed beside others</source>
            <translation>um programa que define ou escolhe um sistema de coordenadas não pode ser colocado ao lado de outros</translation>
        </message>
        <message>
            <source>a program with subroutines, loops or branches is not rewritten</source>
            <translation>um programa com sub-rotinas, laços ou desvios não é reescrito</translation>
        </message>
        <message>
            <source>a quarter of the width</source>
            <translation>um quarto da largura</translation>
        </message>
        <message>
            <source>a rapid crosses the sheet, which a wire cannot</source>
            <translation>um rápido atravessa a chapa, o que um fio não pode</translation>
        </message>
        <message>
            <source>a rapid crosses the stock with the beam on</source>
            <translation>um deslocamento rápido atravessa o bloco com o feixe ligado</translation>
        </message>
        <message>
            <source>a rapid goes sideways while the height is not known</source>
            <translation>um rápido anda de lado sem que a altura seja conhecida</translation>
        </message>
        <message>
            <source>a rapid goes through stock</source>
            <translation>um rápido atravessa o material</translation>
        </message>
        <message>
            <source>a rapid goes with the power on</source>
            <translation>um rápido anda com a potência ligada</translation>
        </message>
        <message>
            <source>a rapid with the tool running is not above all cuts</source>
            <translation>um rápido com a ferramenta ligada não passa acima de todos os cortes</translation>
        </message>
        <message>
            <source>a rate is more than nothing and less than a thousand million</source>
            <translation>uma tarifa é maior que zero e menor que um bilhão</translation>
        </message>
        <message>
            <source>a rate is tried at rest only, not in state {state}</source>
            <translation>uma taxa só é testada em repouso, não no estado {state}</translation>
        </message>
        <message>
            <source>a record was refused: reset first</source>
            <translation>um registro foi recusado: reinicie antes</translation>
        </message>
        <message>
            <source>a rectangle's corner radius must not exceed half of its shorter side</source>
            <translation>o raio de canto de um retângulo não pode passar da metade do seu lado menor</translation>
        </message>
        <message>
            <source>a report of the controller is damaged and was not believed: {report}</source>
            <translation>um relatório do controlador está danificado e não foi considerado: {report}</translation>
        </message>
        <message>
            <source>a request without the session's token</source>
            <translation>um pedido sem a chave da sessão</translation>
        </message>
        <message>
            <source>a rotation of {0}</source>
            <translation>uma rotação de {0}</translation>
        </message>
        <message>
            <source>a rule has one of operation, marks_for and ignore = true</source>
            <translation>uma regra tem um só de operation, marks_for e ignore = true</translation>
        </message>
        <message>
            <source>a scale must be above 0</source>
            <translation>uma escala deve ser maior que 0</translation>
        </message>
        <message>
            <source>a scale must be positive</source>
            <translation>uma escala deve ser positiva</translation>
        </message>
        <message>
            <source>a scheduler on another computer is asked over TLS only: what it is sent and sends is code</source>
            <translation>um escalonador em outro computador só é consultado por TLS: o que ele recebe e envia é código</translation>
        </message>
        <message>
            <source>a session's file belongs to {user} and cannot be opened, so that its port is unknown</source>
            <translation>o arquivo de uma sessão pertence a {user} e não pode ser aberto, de modo que ninguém sabe qual é a sua porta</translation>
        </message>
        <message>
            <source>a setting asks for more steps a second than the controller can give</source>
            <translation>uma configuração pede mais passos por segundo do que o controlador consegue</translation>
        </message>
        <message>
            <source>a shape of the pattern is no circle</source>
            <translation>uma forma do padrão não é um círculo</translation>
        </message>
        <message>
            <source>a share is at most the whole</source>
            <translation>uma fração é no máximo o todo</translation>
        </message>
        <message>
            <source>a signal lasts between 10 ns and a second</source>
            <translation>um sinal dura entre 10 ns e um segundo</translation>
        </message>
        <message>
            <source>a single axis may not be homed here</source>
            <translation>aqui não se pode referenciar um só eixo</translation>
        </message>
        <message>
            <source>a spline moves X and Y only</source>
            <translation>uma spline só move X e Y</translation>
        </message>
        <message>
            <source>a step comes between every microsecond and every minute</source>
            <translation>um passo vem entre cada microssegundo e cada minuto</translation>
        </message>
        <message>
            <source>a step is between a nanometre and 100 mm</source>
            <translation>um passo fica entre um nanômetro e 100 mm</translation>
        </message>
        <message>
            <source>a strip must be the only sheet of an order</source>
            <translation>uma faixa precisa ser a única chapa de um pedido</translation>
        </message>
        <message>
            <source>a subroutine in another file moves: it is not edited with the program</source>
            <translation>uma sub-rotina em outro arquivo faz movimentos: ela não é editada junto com o programa</translation>
        </message>
        <message>
            <source>a subroutine in another file sets a feed: it is not edited with the program</source>
            <translation>uma sub-rotina em outro arquivo define um avanço: ela não é editada junto com o programa</translation>
        </message>
        <message>
            <source>a subroutine may not be defined inside another one</source>
            <translation>uma sub-rotina não pode ser definida dentro de outra</translation>
        </message>
        <message>
            <source>a subroutine takes {arguments} arguments at most</source>
            <translation>uma sub-rotina aceita no máximo {arguments} argumentos</translation>
        </message>
        <message>
            <source>a symbolic link of another user in a folder that everybody may write to is not followed</source>
            <translation>um link simbólico de outro usuário, em uma pasta na qual todos podem gravar, não é seguido</translation>
        </message>
        <message>
            <source>a template has no key '{key}'</source>
            <translation>um modelo não tem a chave '{key}'</translation>
        </message>
        <message>
            <source>a text is too long</source>
            <translation>um texto é longo demais</translation>
        </message>
        <message>
            <source>a text needs one of font, file and single_line</source>
            <translation>um texto precisa de um entre font, file e single_line</translation>
        </message>
        <message>
            <source>a text runs along a line, an arc or a shape: give one of them</source>
            <translation>um texto segue uma linha, um arco ou uma forma: informe um deles</translation>
        </message>
        <message>
            <source>a text runs along one curve, but the shape '{shape}' has several</source>
            <translation>um texto segue uma só curva, mas a forma '{shape}' tem várias</translation>
        </message>
        <message>
            <source>a text runs along the shape '{shape}', which does not stand before it</source>
            <translation>um texto segue a forma '{shape}', que não está antes dele</translation>
        </message>
        <message>
            <source>a thread is cut with a threading tool</source>
            <translation>uma rosca é cortada com uma ferramenta de roscar</translation>
        </message>
        <message>
            <source>a tolerance must be above 0</source>
            <translation>uma tolerância deve ser maior que 0</translation>
        </message>
        <message>
            <source>a tool bit is one tool</source>
            <translation>um arquivo .fctb é uma só ferramenta</translation>
        </message>
        <message>
            <source>a tool change is pending, and this command must wait for its end</source>
            <translation>há uma troca de ferramenta pendente, e este comando precisa esperar o fim dela</translation>
        </message>
        <message>
            <source>a tool length lies along Z only</source>
            <translation>um comprimento de ferramenta fica só ao longo de Z</translation>
        </message>
        <message>
            <source>a tool length of {length:.3f} mm is in force, wanted none (G49)</source>
            <translation>um comprimento de ferramenta de {length:.3f} mm está em vigor, mas não deveria haver nenhum (G49)</translation>
        </message>
        <message>
            <source>a tool of the library has no number nr or no path</source>
            <translation>uma ferramenta da biblioteca não tem número nr ou não tem caminho path</translation>
        </message>
        <message>
            <source>a tooth of the {tool} tool takes too thick a chip</source>
            <translation>um dente da ferramenta {tool} tira um cavaco espesso demais</translation>
        </message>
        <message>
            <source>a tooth of the {tool} tool takes too thick a chip for tool and material</source>
            <translation>um dente da ferramenta {tool} tira um cavaco grosso demais para a ferramenta e o material</translation>
        </message>
        <message>
            <source>a tooth of the {tool} tool takes too thin a chip: it rubs and grows hot</source>
            <translation>um dente da ferramenta {tool} tira um cavaco fino demais: ele esfrega e esquenta</translation>
        </message>
        <message>
            <source>a transform must not collapse the curve</source>
            <translation>uma transformação não pode achatar a curva</translation>
        </message>
        <message>
            <source>a turning tool needs insert, for example "CNMG 120408", or front_deg and back_deg</source>
            <translation>uma ferramenta de tornear precisa de insert, por exemplo "CNMG 120408", ou de front_deg e back_deg</translation>
        </message>
        <message>
            <source>a value in the expression does not fit its operation</source>
            <translation>um valor da expressão não serve para a operação</translation>
        </message>
        <message>
            <source>a value in the expression is too large or too small</source>
            <translation>um valor da expressão é grande ou pequeno demais</translation>
        </message>
        <message>
            <source>a value is larger than the controller allows</source>
            <translation>um valor é maior do que o controlador permite</translation>
        </message>
        <message>
            <source>a value is missing</source>
            <translation>falta um valor</translation>
        </message>
        <message>
            <source>a value is negative where only positive ones are allowed</source>
            <translation>um valor é negativo onde só positivos são permitidos</translation>
        </message>
        <message>
            <source>a value is outside of its range</source>
            <translation>um valor está fora da faixa</translation>
        </message>
        <message>
            <source>a value is zero or negative where only positive ones are allowed</source>
            <translation>um valor é zero ou negativo onde só se permitem positivos</translation>
        </message>
        <message>
            <source>a variation that is not there</source>
            <translation>uma variação que não existe</translation>
        </message>
        <message>
            <source>a whole number</source>
            <translation>um número inteiro</translation>
        </message>
        <message>
            <source>a whole number from 0</source>
            <translation>um número inteiro a partir de 0</translation>
        </message>
        <message>
            <source>a word does not begin with a letter</source>
            <translation>uma palavra não começa com letra</translation>
        </message>
        <message>
            <source>a word has a value that it cannot have</source>
            <translation>uma palavra tem um valor que não pode ter</translation>
        </message>
        <message>
            <source>a word is a letter and a number</source>
            <translation>uma palavra é uma letra e um número</translation>
        </message>
        <message>
            <source>a word is twice in one line</source>
            <translation>uma palavra aparece duas vezes na linha</translation>
        </message>
        <message>
            <source>a {kind} tool has no insert of ISO 1832</source>
            <translation>uma ferramenta {kind} não tem pastilha da ISO 1832</translation>
        </message>
        <message>
            <source>a {kind} tool {verb} {key}</source>
            <translation>uma ferramenta {kind} {verb} {key}</translation>
        </message>
        <message>
            <source>a {shape} does not cut from the edge</source>
            <translation>uma ferramenta {shape} não corta a partir da borda</translation>
        </message>
        <message>
            <source>a {shape} tool has no {key}</source>
            <translation>uma ferramenta {shape} não tem {key}</translation>
        </message>
        <message>
            <source>a {tool_shape} cuts through at any height: no tabs, no ramp</source>
            <translation>{tool_shape} atravessa em qualquer altura: sem pontes, sem rampa</translation>
        </message>
        <message>
            <source>a {tool_shape} tool does not drill</source>
            <translation>uma ferramenta {tool_shape} não fura</translation>
        </message>
        <message>
            <source>a {tool_shape} tool leaves no flat floor</source>
            <translation>uma ferramenta {tool_shape} não deixa o fundo plano</translation>
        </message>
        <message>
            <source>a {tool_shape} tool mills no thread</source>
            <translation>uma ferramenta {tool_shape} não fresa rosca</translation>
        </message>
        <message>
            <source>a {what} needs one of {ways}; it has {told}</source>
            <translation>{what} precisa de um entre {ways}; tem {told}</translation>
        </message>
        <message>
            <source>above 0 and below the least</source>
            <translation>acima de 0 e abaixo do mínimo</translation>
        </message>
        <message>
            <source>above 0 mm</source>
            <translation>acima de 0 mm</translation>
        </message>
        <message>
            <source>above 0 mm/min</source>
            <translation>acima de 0 mm/min</translation>
        </message>
        <message>
            <source>above 0, at most {ramp_max_deg:g} deg, no tabs</source>
            <translation>acima de 0, no máximo {ramp_max_deg:g} deg, sem pontes</translation>
        </message>
        <message>
            <source>above 0, below {diameter_mm:g} mm</source>
            <translation>acima de 0, abaixo de {diameter_mm:g} mm</translation>
        </message>
        <message>
            <source>above {0} mm</source>
            <translation>acima de {0} mm</translation>
        </message>
        <message>
            <source>above {highest_cut:g} mm</source>
            <translation>acima de {highest_cut:g} mm</translation>
        </message>
        <message>
            <source>act = "switch" and line belong together</source>
            <translation>act = "switch" e line andam juntos</translation>
        </message>
        <message>
            <source>add F, or write G94 before</source>
            <translation>acrescente F ou escreva G94 antes</translation>
        </message>
        <message>
            <source>add G0 or G1</source>
            <translation>acrescente G0 ou G1</translation>
        </message>
        <message>
            <source>add closed = true to the rule, or mend the drawing</source>
            <translation>acrescente closed = true à regra, ou conserte o desenho</translation>
        </message>
        <message>
            <source>add control points</source>
            <translation>acrescente pontos de controle</translation>
        </message>
        <message>
            <source>add one before the first cut</source>
            <translation>acrescente uma antes do primeiro corte</translation>
        </message>
        <message>
            <source>add the missing pass, or lower the stepover or the stepdown</source>
            <translation>acrescente o passe que falta, ou diminua a penetração de trabalho ou a profundidade de corte</translation>
        </message>
        <message>
            <source>add the missing pass, or state the stock to leave</source>
            <translation>acrescente o passe que falta, ou informe o sobremetal</translation>
        </message>
        <message>
            <source>add the other</source>
            <translation>acrescente a outra</translation>
        </message>
        <message>
            <source>add the tool or correct the T word</source>
            <translation>adicione a ferramenta ou corrija a palavra T</translation>
        </message>
        <message>
            <source>add them</source>
            <translation>acrescente-as</translation>
        </message>
        <message>
            <source>add what it is to set</source>
            <translation>acrescente o que deve ser definido</translation>
        </message>
        <message>
            <source>add yourself to its group (sudo usermod -aG dialout $USER) and log in again</source>
            <translation>entre no grupo dela (sudo usermod -aG dialout $USER) e faça login de novo</translation>
        </message>
        <message>
            <source>add {key} = and its value</source>
            <translation>acrescente {key} = e o seu valor</translation>
        </message>
        <message>
            <source>add {letter} to the line</source>
            <translation>acrescente {letter} à linha</translation>
        </message>
        <message>
            <source>after a stop the first move names all its axes, on one straight way: let the machine stand above the work</source>
            <translation>depois de uma parada o primeiro movimento nomeia todos os seus eixos, em um só trajeto reto: deixe a máquina acima da peça</translation>
        </message>
        <message>
            <source>all before line {first_line} is cut</source>
            <translation>tudo antes da linha {first_line} está cortado</translation>
        </message>
        <message>
            <source>all of it</source>
            <translation>tudo</translation>
        </message>
        <message>
            <source>all {total} lines are cut, the machine is idle</source>
            <translation>todas as {total} linhas foram usinadas, a máquina está pronta</translation>
        </message>
        <message>
            <source>an O-word begins a line of a whole program, in dialects that have them: here it is not read</source>
            <translation>uma palavra O começa uma linha de um programa inteiro, nos dialetos que a têm: aqui ela não é lida</translation>
        </message>
        <message>
            <source>an analogue input is only read, with L0</source>
            <translation>uma entrada analógica só é lida, com L0</translation>
        </message>
        <message>
            <source>an angle between two sides lies between 0 and 180 degrees</source>
            <translation>um ângulo entre dois lados fica entre 0 e 180 graus</translation>
        </message>
        <message>
            <source>an arc by radius may not end where it starts</source>
            <translation>um arco dado pelo raio não pode terminar onde começa</translation>
        </message>
        <message>
            <source>an arc in the plane {plane} would be no arc any more</source>
            <translation>um arco no plano {plane} deixaria de ser um arco</translation>
        </message>
        <message>
            <source>an arc needs a known start point</source>
            <translation>um arco precisa de um ponto inicial conhecido</translation>
        </message>
        <message>
            <source>an arc needs arc = "cw" or "ccw", and radius_mm or centre</source>
            <translation>um arco precisa de arc = "cw" ou "ccw", e de radius_mm ou centre</translation>
        </message>
        <message>
            <source>an arc needs radius_mm or centre, not both</source>
            <translation>um arco precisa de radius_mm ou centre, não de ambos</translation>
        </message>
        <message>
            <source>an arc of another plane than XY</source>
            <translation>um arco em outro plano que não XY</translation>
        </message>
        <message>
            <source>an arc of several turns cannot be sent to a controller of this computer</source>
            <translation>um arco de várias voltas não pode ser enviado a um controlador deste computador</translation>
        </message>
        <message>
            <source>an arc scaled unevenly is no arc</source>
            <translation>um arco escalado de modo desigual não é mais um arco</translation>
        </message>
        <message>
            <source>an arc takes either R or a centre</source>
            <translation>um arco aceita R ou um centro, não os dois</translation>
        </message>
        <message>
            <source>an arc without numbers</source>
            <translation>um arco sem números</translation>
        </message>
        <message>
            <source>an axis is missing: {text}</source>
            <translation>falta um eixo: {text}</translation>
        </message>
        <message>
            <source>an edge of the solid is no curve: {error}</source>
            <translation>uma aresta do sólido não é uma curva: {error}</translation>
        </message>
        <message>
            <source>an edge of the solid is of no kind that is known</source>
            <translation>uma aresta do sólido é de um tipo desconhecido</translation>
        </message>
        <message>
            <source>an expression begins with [</source>
            <translation>uma expressão começa com [</translation>
        </message>
        <message>
            <source>an external reference, whose file is not opened</source>
            <translation>uma referência externa, cujo arquivo não é aberto</translation>
        </message>
        <message>
            <source>an incremental move needs a known position</source>
            <translation>um movimento incremental precisa de uma posição conhecida</translation>
        </message>
        <message>
            <source>an input and output expander failed</source>
            <translation>um expansor de entradas e saídas falhou</translation>
        </message>
        <message>
            <source>an input and output expander was reset</source>
            <translation>um expansor de entradas e saídas foi reiniciado</translation>
        </message>
        <message>
            <source>an input was active at start</source>
            <translation>uma entrada estava ativa na partida</translation>
        </message>
        <message>
            <source>an inverse-time feed needs a known position</source>
            <translation>um avanço em tempo inverso precisa de uma posição conhecida</translation>
        </message>
        <message>
            <source>an offset came damaged: {error}</source>
            <translation>um deslocamento chegou danificado: {error}</translation>
        </message>
        <message>
            <source>an operation uses tool {number}, which neither the job nor {form_file} has</source>
            <translation>uma operação usa a ferramenta {number}, que nem o trabalho nem {form_file} têm</translation>
        </message>
        <message>
            <source>an operator is missing or unknown</source>
            <translation>um operador falta ou é desconhecido</translation>
        </message>
        <message>
            <source>an order names an item that is not there</source>
            <translation>uma ordem nomeia um item que não existe</translation>
        </message>
        <message>
            <source>an outline or island is open</source>
            <translation>um contorno ou uma ilha está aberto</translation>
        </message>
        <message>
            <source>and {corners} smaller ones</source>
            <translation>e mais {corners} menores</translation>
        </message>
        <message>
            <source>another connection is using the controller</source>
            <translation>outra conexão está usando o controlador</translation>
        </message>
        <message>
            <source>another task is open in the task panel</source>
            <translation>outra tarefa está aberta no painel de tarefas</translation>
        </message>
        <message>
            <source>another user listens there</source>
            <translation>outro usuário escuta ali</translation>
        </message>
        <message>
            <source>another user's</source>
            <translation>de outro usuário</translation>
        </message>
        <message>
            <source>approached from above, the axis stands below where it stands when approached from below</source>
            <translation>vindo de cima, o eixo fica abaixo de onde fica vindo de baixo</translation>
        </message>
        <message>
            <source>arcs are in XY</source>
            <translation>os arcos ficam em XY</translation>
        </message>
        <message>
            <source>arcs outside the plane XY</source>
            <translation>arcos fora do plano XY</translation>
        </message>
        <message>
            <source>ask for at most {fewer}</source>
            <translation>peça no máximo {fewer}</translation>
        </message>
        <message>
            <source>ask for at most {fewer}, or {narrower}</source>
            <translation>peça no máximo {fewer}, ou {narrower}</translation>
        </message>
        <message>
            <source>ask for it again</source>
            <translation>peça-o de novo</translation>
        </message>
        <message>
            <source>ask for the right to use it</source>
            <translation>peça permissão para usá-la</translation>
        </message>
        <message>
            <source>ask for the way back again</source>
            <translation>peça o caminho de volta de novo</translation>
        </message>
        <message>
            <source>assign it before</source>
            <translation>atribua um valor a ele antes</translation>
        </message>
        <message>
            <source>at least</source>
            <translation>no mínimo</translation>
        </message>
        <message>
            <source>at least the kerf of {kerf_mm:g} mm</source>
            <translation>no mínimo a largura do corte de {kerf_mm:g} mm</translation>
        </message>
        <message>
            <source>at least {0} deg: a nose angle of {1} deg or less</source>
            <translation>no mínimo {0} graus: um ângulo de ponta de {1} graus ou menos</translation>
        </message>
        <message>
            <source>at least {0} mm</source>
            <translation>no mínimo {0} mm</translation>
        </message>
        <message>
            <source>at least {chord:.4f} mm</source>
            <translation>ao menos {chord:.4f} mm</translation>
        </message>
        <message>
            <source>at least {depth_mm:.3g} mm</source>
            <translation>ao menos {depth_mm:.3g} mm</translation>
        </message>
        <message>
            <source>at least {least:g} mm</source>
            <translation>no mínimo {least:g} mm</translation>
        </message>
        <message>
            <source>at least {least_mm:.3g} mm</source>
            <translation>ao menos {least_mm:.3g} mm</translation>
        </message>
        <message>
            <source>at least {length_mm:.3g} mm</source>
            <translation>ao menos {length_mm:.3g} mm</translation>
        </message>
        <message>
            <source>at least {need_mm:.3f} mm</source>
            <translation>ao menos {need_mm:.3f} mm</translation>
        </message>
        <message>
            <source>at least {rough_mm:.3g} mm</source>
            <translation>ao menos {rough_mm:.3g} mm</translation>
        </message>
        <message>
            <source>at least {z:g}</source>
            <translation>no mínimo {z:g}</translation>
        </message>
        <message>
            <source>at least {z_mm:g} mm</source>
            <translation>ao menos {z_mm:g} mm</translation>
        </message>
        <message>
            <source>at most</source>
            <translation>no máximo</translation>
        </message>
        <message>
            <source>at most {0} deg</source>
            <translation>no máximo {0} graus</translation>
        </message>
        <message>
            <source>at most {0} deg: an entering angle of {1} deg or more</source>
            <translation>no máximo {0} graus: um ângulo de posição de {1} graus ou mais</translation>
        </message>
        <message>
            <source>at most {largest_tool}</source>
            <translation>no máximo {largest_tool}</translation>
        </message>
        <message>
            <source>at most {longest:g} times</source>
            <translation>no máximo {longest:g} vezes</translation>
        </message>
        <message>
            <source>at most {most_mm:.2f} mm</source>
            <translation>no máximo {most_mm:.2f} mm</translation>
        </message>
        <message>
            <source>at most {narrowest_mm:.3f} mm</source>
            <translation>no máximo {narrowest_mm:.3f} mm</translation>
        </message>
        <message>
            <source>at most {room_mm:.3f} mm</source>
            <translation>no máximo {room_mm:.3f} mm</translation>
        </message>
        <message>
            <source>at the profile's interval the letters are too fast for {axis}</source>
            <translation>no intervalo do perfil as letras são rápidas demais para {axis}</translation>
        </message>
        <message>
            <source>at z {0} mm, radius {1} mm</source>
            <translation>em z {0} mm, raio {1} mm</translation>
        </message>
        <message>
            <source>attach to it again</source>
            <translation>ligue-se a ela de novo</translation>
        </message>
        <message>
            <source>attach to that one</source>
            <translation>ligue-se àquela</translation>
        </message>
        <message>
            <source>attach to the session again</source>
            <translation>ligue-se de novo à sessão</translation>
        </message>
        <message>
            <source>automatic mode: from here on the link cannot stop the lathe, and only switching it off returns it to manual mode</source>
            <translation>modo automático: daqui em diante nada para o torno pela sua ligação, e não há volta ao modo manual até que ele seja desligado</translation>
        </message>
        <message>
            <source>axis offsets may not be changed</source>
            <translation>os deslocamentos dos eixos não podem ser mudados</translation>
        </message>
        <message>
            <source>axis words stand where no command uses them</source>
            <translation>há palavras de eixo onde nenhum comando as usa</translation>
        </message>
        <message>
            <source>axis.{missing} is missing</source>
            <translation>falta axis.{missing}</translation>
        </message>
        <message>
            <source>axis.{without}.jerk_mm_s3 is missing: ramp = "s_curve" needs it</source>
            <translation>falta axis.{without}.jerk_mm_s3: ramp = "s_curve" precisa dele</translation>
        </message>
        <message>
            <source>back along the cut</source>
            <translation>volta pelo corte</translation>
        </message>
        <message>
            <source>back edge at {0} deg</source>
            <translation>aresta de trás a {0} graus</translation>
        </message>
        <message>
            <source>back to where the program paused: up, over, down</source>
            <translation>volta ao ponto em que o programa pausou: sobe, desloca, desce</translation>
        </message>
        <message>
            <source>backlash cannot be compensated in an arc with an absolute centre</source>
            <translation>a folga dos eixos não pode ser compensada em um arco com centro absoluto</translation>
        </message>
        <message>
            <source>backlash cannot be compensated in rotated coordinates</source>
            <translation>a folga dos eixos não pode ser compensada em coordenadas giradas</translation>
        </message>
        <message>
            <source>backlash cannot be compensated in the dialect {dialect}</source>
            <translation>na linguagem de {dialect} não há como compensar a folga</translation>
        </message>
        <message>
            <source>backlash cannot be compensated within this line</source>
            <translation>a folga dos eixos não pode ser compensada dentro desta linha</translation>
        </message>
        <message>
            <source>backlash has three values, one for each axis</source>
            <translation>a folga é informada para três eixos</translation>
        </message>
        <message>
            <source>backlash_mm must be below the travel of the axis</source>
            <translation>backlash_mm deve ser menor que o curso do eixo</translation>
        </message>
        <message>
            <source>bar_mm must be below smallest_bore_mm</source>
            <translation>bar_mm deve ser menor que smallest_bore_mm</translation>
        </message>
        <message>
            <source>batch journal</source>
            <translation>diário de pedido</translation>
        </message>
        <message>
            <source>before it starts set the Z zero with its tool</source>
            <translation>antes de iniciá-lo, defina o zero de Z com a ferramenta dele</translation>
        </message>
        <message>
            <source>begin beside the sheet and enter at its edge</source>
            <translation>comece ao lado da chapa e entre pela borda</translation>
        </message>
        <message>
            <source>begin farther away</source>
            <translation>comece mais longe</translation>
        </message>
        <message>
            <source>begin it at the end face</source>
            <translation>comece-o na face</translation>
        </message>
        <message>
            <source>begin lower or take smaller steps</source>
            <translation>comece mais baixo ou use passos menores</translation>
        </message>
        <message>
            <source>begin operation:</source>
            <translation>início da operação:</translation>
        </message>
        <message>
            <source>begin operation: {name}</source>
            <translation>início da operação: {name}</translation>
        </message>
        <message>
            <source>begin the comment with ;</source>
            <translation>comece o comentário com ;</translation>
        </message>
        <message>
            <source>begin the file with the line '# units: {other}', or say that unit</source>
            <translation>comece o arquivo com a linha '# units: {other}', ou informe essa unidade</translation>
        </message>
        <message>
            <source>begin the program with a rapid to a safe Z</source>
            <translation>comece o programa com um rápido até um Z seguro</translation>
        </message>
        <message>
            <source>begin with rapids that name X, Y and Z</source>
            <translation>comece com rápidos que indiquem X, Y e Z</translation>
        </message>
        <message>
            <source>below {depth_mm:g} mm</source>
            <translation>abaixo de {depth_mm:g} mm</translation>
        </message>
        <message>
            <source>below {length_mm:.3f} mm</source>
            <translation>abaixo de {length_mm:.3f} mm</translation>
        </message>
        <message>
            <source>below {minor_mm:.3f} mm</source>
            <translation>abaixo de {minor_mm:.3f} mm</translation>
        </message>
        <message>
            <source>below {narrowest_mm:g} mm</source>
            <translation>abaixo de {narrowest_mm:g} mm</translation>
        </message>
        <message>
            <source>below {total_mm:g} mm</source>
            <translation>abaixo de {total_mm:g} mm</translation>
        </message>
        <message>
            <source>belt_pitch_mm and pulley_teeth belong together</source>
            <translation>belt_pitch_mm e pulley_teeth andam juntos</translation>
        </message>
        <message>
            <source>between curves {one} and {other} the kerf does not fit, at X{x:.3f} Y{y:.3f}</source>
            <translation>entre as curvas {one} e {other} a largura do corte não cabe, em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>beyond a million nothing of the shape is left</source>
            <translation>além de um milhão nada resta da forma</translation>
        </message>
        <message>
            <source>beyond these a step lasts over a minute or no time</source>
            <translation>além destes um passo dura mais de um minuto ou tempo nenhum</translation>
        </message>
        <message>
            <source>blur the picture, scale it down, or choose another threshold</source>
            <translation>desfoque a imagem, reduza-a ou escolha outro limiar</translation>
        </message>
        <message>
            <source>bore_mm belongs to a stock of the form 'tube', and to no other</source>
            <translation>bore_mm pertence a um material da forma 'tube', e a nenhum outro</translation>
        </message>
        <message>
            <source>bore_mm must be below diameter_mm, {limit}</source>
            <translation>bore_mm deve ser menor que diameter_mm, {limit}</translation>
        </message>
        <message>
            <source>boring takes a tool for the inside</source>
            <translation>o mandrilamento usa uma ferramenta interna</translation>
        </message>
        <message>
            <source>both radii must be positive</source>
            <translation>os dois semieixos devem ser positivos</translation>
        </message>
        <message>
            <source>break the line</source>
            <translation>divida a linha</translation>
        </message>
        <message>
            <source>bring it back, or choose another file</source>
            <translation>traga-o de volta, ou escolha outro arquivo</translation>
        </message>
        <message>
            <source>bring it to Idle first</source>
            <translation>deixe-a antes em Idle (pronta)</translation>
        </message>
        <message>
            <source>bytes when it is unpacked</source>
            <translation>bytes depois de descompactado</translation>
        </message>
        <message>
            <source>canned cycles may not be used</source>
            <translation>ciclos fixos não podem ser usados</translation>
        </message>
        <message>
            <source>catch it, and stop the spindle after it</source>
            <translation>apare a peça, e pare o fuso depois</translation>
        </message>
        <message>
            <source>chains have fewer lines and arcs</source>
            <translation>cadeias têm menos linhas e arcos</translation>
        </message>
        <message>
            <source>chamfers and fillets lie between two lines</source>
            <translation>chanfros e arredondamentos ficam entre duas retas</translation>
        </message>
        <message>
            <source>change F in the program</source>
            <translation>altere F no programa</translation>
        </message>
        <message>
            <source>change one of its dimensions</source>
            <translation>mude uma das dimensões</translation>
        </message>
        <message>
            <source>change one of them</source>
            <translation>mude um deles</translation>
        </message>
        <message>
            <source>change the distance or the tolerance a little</source>
            <translation>mude um pouco a distância ou a tolerância</translation>
        </message>
        <message>
            <source>change the text to start it again</source>
            <translation>altere o texto para iniciá-lo de novo</translation>
        </message>
        <message>
            <source>change the tool at an M0 pause, or split the program at tool changes</source>
            <translation>troque a ferramenta em uma pausa M0 ou divida o programa nas trocas de ferramenta</translation>
        </message>
        <message>
            <source>change the tool, then resume</source>
            <translation>troque a ferramenta e continue</translation>
        </message>
        <message>
            <source>change to tool {0}</source>
            <translation>troque para a ferramenta {0}</translation>
        </message>
        <message>
            <source>change_ms is so small that there are more than {most_waits} waits</source>
            <translation>change_ms é tão pequeno que há mais de {most_waits} esperas</translation>
        </message>
        <message>
            <source>characters with its entities in their places</source>
            <translation>caracteres com as entidades substituídas</translation>
        </message>
        <message>
            <source>charts are there for: {processes}</source>
            <translation>há tabelas para: {processes}</translation>
        </message>
        <message>
            <source>check both switches</source>
            <translation>verifique os dois fins de curso</translation>
        </message>
        <message>
            <source>check both switches, then home again</source>
            <translation>verifique os dois fins de curso e referencie de novo</translation>
        </message>
        <message>
            <source>check cable and baud rate</source>
            <translation>verifique o cabo e a taxa (baud)</translation>
        </message>
        <message>
            <source>check cable and power of the machine, then connect again: that starts the controller of {machine} anew</source>
            <translation>verifique o cabo e a alimentação da máquina e conecte de novo: isso reinicia o controlador de {machine}</translation>
        </message>
        <message>
            <source>check cable and power, then move the tool to the work zero and set it there before its next move</source>
            <translation>verifique cabo e alimentação; depois leve a ferramenta ao zero-peça e defina-o ali antes do próximo movimento</translation>
        </message>
        <message>
            <source>check cable and power; home the machine or set its zero again before the next cut</source>
            <translation>verifique cabo e alimentação; referencie a máquina ou defina o zero de novo antes do próximo corte</translation>
        </message>
        <message>
            <source>check cable, grounding and baud rate, and that this program supports the firmware</source>
            <translation>verifique o cabo, o aterramento e a velocidade (baud), e se o firmware é um dos que este programa conhece</translation>
        </message>
        <message>
            <source>check cable, power and other programs on this port</source>
            <translation>verifique cabo, alimentação e outros programas nesta porta</translation>
        </message>
        <message>
            <source>check its cable and settings, then home the machine</source>
            <translation>verifique o cabo e as configurações dele e referencie a máquina</translation>
        </message>
        <message>
            <source>check its cable and supply, then home the machine</source>
            <translation>verifique o cabo e a alimentação dele e referencie a máquina</translation>
        </message>
        <message>
            <source>check its supply and cable</source>
            <translation>verifique a alimentação e o cabo</translation>
        </message>
        <message>
            <source>check its supply and cable, then send again</source>
            <translation>verifique a alimentação e o cabo e envie de novo</translation>
        </message>
        <message>
            <source>check its supply and the reset button; home the machine or set its zero before the next cut</source>
            <translation>verifique a alimentação e o botão de reset; referencie a máquina ou defina o zero antes do próximo corte</translation>
        </message>
        <message>
            <source>check power, cable, port and baud rate of the controller</source>
            <translation>verifique alimentação, cabo, porta e taxa (baud) do controlador</translation>
        </message>
        <message>
            <source>check that it is a grbl 1.1 controller and that the baud rate is right</source>
            <translation>verifique se é um controlador grbl 1.1 e se a taxa (baud) está certa</translation>
        </message>
        <message>
            <source>check the baud rate and what is connected</source>
            <translation>verifique a taxa (baud) e o que está conectado</translation>
        </message>
        <message>
            <source>check the baud rate, and which reports the controller sends unasked</source>
            <translation>verifique a velocidade (baud) e quais relatórios o controlador envia por conta própria</translation>
        </message>
        <message>
            <source>check the cable</source>
            <translation>verifique o cabo</translation>
        </message>
        <message>
            <source>check the cable, and look that the controller is not in check mode ($C leaves it); then send again</source>
            <translation>verifique o cabo, e veja que o controlador não esteja no modo de verificação ($C sai dele); depois envie de novo</translation>
        </message>
        <message>
            <source>check the depth, or lay a spoil board under the stock</source>
            <translation>verifique a profundidade, ou ponha uma chapa de sacrifício sob o bloco</translation>
        </message>
        <message>
            <source>check the probe's wiring and plate, then unlock with $X</source>
            <translation>verifique a fiação e a placa do apalpador e destrave com $X</translation>
        </message>
        <message>
            <source>check the program again, and send it with the certificate that this gives</source>
            <translation>verifique o programa de novo e envie-o com o certificado que isso gera</translation>
        </message>
        <message>
            <source>check the state of the machine now, then answer again</source>
            <translation>veja como a máquina está agora e responda a isso</translation>
        </message>
        <message>
            <source>check the switches, and max_travel_mm in its configuration</source>
            <translation>verifique os fins de curso e max_travel_mm na configuração</translation>
        </message>
        <message>
            <source>check the switches, and travel $130 to $132</source>
            <translation>verifique os fins de curso e os cursos $130 a $132</translation>
        </message>
        <message>
            <source>check which curves are outlines and which are islands, and stock_to_leave_mm</source>
            <translation>verifique quais curvas são contornos e quais são ilhas, e stock_to_leave_mm</translation>
        </message>
        <message>
            <source>checksums are not part of this dialect</source>
            <translation>somas de verificação não fazem parte deste dialeto</translation>
        </message>
        <message>
            <source>chip_load_min_mm must not exceed chip_load_max_mm</source>
            <translation>chip_load_min_mm não pode exceder chip_load_max_mm</translation>
        </message>
        <message>
            <source>choose S from {min_rpm:g} to {max_rpm:g}</source>
            <translation>escolha S de {min_rpm:g} a {max_rpm:g}</translation>
        </message>
        <message>
            <source>choose a folder that exists and that you may write to</source>
            <translation>escolha uma pasta que exista e em que você possa gravar</translation>
        </message>
        <message>
            <source>choose a line that was cut after the last tool change and before this one</source>
            <translation>escolha uma linha cortada depois da última troca de ferramenta e antes desta</translation>
        </message>
        <message>
            <source>choose a machine with a Z axis</source>
            <translation>escolha uma máquina com eixo Z</translation>
        </message>
        <message>
            <source>choose a sketch with circles or points, or give the places by numbers</source>
            <translation>escolha um esboço com círculos ou pontos, ou dê os lugares por números</translation>
        </message>
        <message>
            <source>choose a sketch, closed wires or faces for it</source>
            <translation>escolha um esboço, fios fechados ou faces para ela</translation>
        </message>
        <message>
            <source>choose a sketch, wire, B-spline or freehand line for it</source>
            <translation>escolha para ela um esboço, arame, B-spline ou linha à mão livre</translation>
        </message>
        <message>
            <source>choose a sketch, wires or faces for it</source>
            <translation>escolha um esboço, fios ou faces para ela</translation>
        </message>
        <message>
            <source>choose a smaller tool</source>
            <translation>escolha uma ferramenta menor</translation>
        </message>
        <message>
            <source>choose a smaller tool or less stock to leave</source>
            <translation>escolha uma ferramenta menor ou menos sobremetal</translation>
        </message>
        <message>
            <source>choose a smaller tool, or drill</source>
            <translation>escolha uma ferramenta menor ou fure</translation>
        </message>
        <message>
            <source>choose a solid, for example a box</source>
            <translation>escolha um sólido, por exemplo uma caixa</translation>
        </message>
        <message>
            <source>choose a tool of at most {widest:.3f} mm diameter</source>
            <translation>escolha uma ferramenta de no máximo {widest:.3f} mm de diâmetro</translation>
        </message>
        <message>
            <source>choose a tool that reaches further, or cut this part with another one</source>
            <translation>escolha uma ferramenta de maior alcance, ou corte esta parte com outra</translation>
        </message>
        <message>
            <source>choose an earlier line</source>
            <translation>escolha uma linha anterior</translation>
        </message>
        <message>
            <source>choose an earlier place</source>
            <translation>escolha um ponto anterior</translation>
        </message>
        <message>
            <source>choose another</source>
            <translation>escolha outro</translation>
        </message>
        <message>
            <source>choose another file, or another machine</source>
            <translation>escolha outro arquivo, ou outra máquina</translation>
        </message>
        <message>
            <source>choose another font, or other characters</source>
            <translation>escolha outra fonte ou outros caracteres</translation>
        </message>
        <message>
            <source>choose another name</source>
            <translation>escolha outro nome</translation>
        </message>
        <message>
            <source>choose another process in the job, or delete the operation</source>
            <translation>escolha outro processo no trabalho, ou apague a operação</translation>
        </message>
        <message>
            <source>choose another side</source>
            <translation>escolha outro lado</translation>
        </message>
        <message>
            <source>choose another threshold, or invert it</source>
            <translation>escolha outro limiar, ou inverta a imagem</translation>
        </message>
        <message>
            <source>choose its job</source>
            <translation>escolha o trabalho dele</translation>
        </message>
        <message>
            <source>choose one of the job's tools for it</source>
            <translation>escolha para ela uma das ferramentas do trabalho</translation>
        </message>
        <message>
            <source>choose one of them</source>
            <translation>escolha uma delas</translation>
        </message>
        <message>
            <source>choose one of them, or cut them all with a pocket</source>
            <translation>escolha um deles, ou usine todos com um bolsão</translation>
        </message>
        <message>
            <source>choose one of: {choices}</source>
            <translation>escolha um destes: {choices}</translation>
        </message>
        <message>
            <source>choose other values, or try again</source>
            <translation>escolha outros valores, ou tente de novo</translation>
        </message>
        <message>
            <source>choose the job's material</source>
            <translation>escolha o material do trabalho</translation>
        </message>
        <message>
            <source>choose the pass yourself: the program sends lines again, so line {line} alone is no place</source>
            <translation>escolha você mesmo o passe: o programa envia linhas de novo, por isso só a linha {line} não é um lugar</translation>
        </message>
        <message>
            <source>choose the right machine profile, or correct the settings</source>
            <translation>escolha o perfil de máquina certo, ou corrija as configurações</translation>
        </message>
        <message>
            <source>circles and points of several drawings that stand about the same centre, one hole each: {twice}</source>
            <translation>círculos e pontos de vários desenhos em torno do mesmo centro, um furo para cada: {twice}</translation>
        </message>
        <message>
            <source>clamp the tool with more stickout</source>
            <translation>deixe a ferramenta mais para fora do porta-ferramenta</translation>
        </message>
        <message>
            <source>clear the cause, then reset the controller</source>
            <translation>elimine a causa e reinicie o controlador</translation>
        </message>
        <message>
            <source>clearance_mm must not be below retract_mm</source>
            <translation>clearance_mm (altura de segurança) não pode ser menor que retract_mm (retração)</translation>
        </message>
        <message>
            <source>close it</source>
            <translation>feche-a</translation>
        </message>
        <message>
            <source>close it and home again</source>
            <translation>feche-a e referencie de novo</translation>
        </message>
        <message>
            <source>close it and resume, then go back</source>
            <translation>feche-a e retome, depois volte</translation>
        </message>
        <message>
            <source>close it first</source>
            <translation>feche-a antes</translation>
        </message>
        <message>
            <source>close it first: cncstepper disconnect</source>
            <translation>feche-a antes: cncstepper disconnect</translation>
        </message>
        <message>
            <source>close it or set closed = false</source>
            <translation>feche-a ou use closed = false</translation>
        </message>
        <message>
            <source>close it with )</source>
            <translation>feche-o com )</translation>
        </message>
        <message>
            <source>close it with &gt;</source>
            <translation>feche-o com &gt;</translation>
        </message>
        <message>
            <source>close it with ]</source>
            <translation>feche-a com ]</translation>
        </message>
        <message>
            <source>close it, or leave only closed lines in the drawing</source>
            <translation>feche-a ou deixe só linhas fechadas no desenho</translation>
        </message>
        <message>
            <source>close it, or name another layer</source>
            <translation>feche-o ou indique outra camada</translation>
        </message>
        <message>
            <source>close it, or use side "left", "right" or "on"</source>
            <translation>feche-a ou use o lado "left", "right" ou "on"</translation>
        </message>
        <message>
            <source>close it: draw a whole ellipse instead of an arc</source>
            <translation>feche-a: desenhe uma elipse inteira em vez de um arco</translation>
        </message>
        <message>
            <source>close other programs on this port and check the cable; then set the zero again</source>
            <translation>feche outros programas nesta porta e verifique o cabo; depois defina o zero de novo</translation>
        </message>
        <message>
            <source>close the door, then resume</source>
            <translation>feche a porta e retome</translation>
        </message>
        <message>
            <source>close the other connection, a web page or a pendant</source>
            <translation>feche a outra conexão, uma página da web ou um controle manual</translation>
        </message>
        <message>
            <source>close the other program that holds it</source>
            <translation>feche o outro programa que a ocupa</translation>
        </message>
        <message>
            <source>close the safety door and resume, or reset it</source>
            <translation>feche a porta de segurança e retome, ou reinicie-a</translation>
        </message>
        <message>
            <source>close the safety door, then resume</source>
            <translation>feche a porta de segurança e retome</translation>
        </message>
        <message>
            <source>closed belongs to points</source>
            <translation>closed só vale para points</translation>
        </message>
        <message>
            <source>cncstepper disconnect --port {port}, then connect again</source>
            <translation>cncstepper disconnect --port {port}, depois conecte de novo</translation>
        </message>
        <message>
            <source>compute it in several lines</source>
            <translation>calcule-a em várias linhas</translation>
        </message>
        <message>
            <source>connect again</source>
            <translation>conecte de novo</translation>
        </message>
        <message>
            <source>connect to its port without a machine profile</source>
            <translation>conecte à porta dele sem perfil de máquina</translation>
        </message>
        <message>
            <source>constant surface speed became a speed a move</source>
            <translation>a velocidade de corte constante virou uma rotação por movimento</translation>
        </message>
        <message>
            <source>convert the text to paths in the drawing program</source>
            <translation>converta o texto em caminhos no programa de desenho</translation>
        </message>
        <message>
            <source>coordinate systems may not be changed</source>
            <translation>os sistemas de coordenadas não podem ser mudados</translation>
        </message>
        <message>
            <source>coordinates alone may not follow {motion_name}</source>
            <translation>coordenadas sozinhas não podem vir depois de {motion_name}</translation>
        </message>
        <message>
            <source>core_diameter_mm must not exceed diameter_mm</source>
            <translation>core_diameter_mm não pode exceder diameter_mm</translation>
        </message>
        <message>
            <source>corner_a = [{0}, {1}], corner_b = [{2}, {3}]</source>
            <translation>corner_a = [{0}, {1}], corner_b = [{2}, {3}]</translation>
        </message>
        <message>
            <source>corner_radius_mm must not exceed half of diameter_mm</source>
            <translation>corner_radius_mm não pode passar da metade de diameter_mm</translation>
        </message>
        <message>
            <source>correct R or the end point</source>
            <translation>corrija R ou o ponto final</translation>
        </message>
        <message>
            <source>correct R or {normal}</source>
            <translation>corrija R ou {normal}</translation>
        </message>
        <message>
            <source>correct centre or to</source>
            <translation>corrija centre ou to</translation>
        </message>
        <message>
            <source>correct diameter_mm</source>
            <translation>corrija diameter_mm</translation>
        </message>
        <message>
            <source>correct it</source>
            <translation>corrija-o</translation>
        </message>
        <message>
            <source>correct it; paths are relative to the order</source>
            <translation>corrija; os caminhos são relativos ao pedido</translation>
        </message>
        <message>
            <source>correct its configuration file, then restart the controller</source>
            <translation>corrija o arquivo de configuração e reinicie o controlador</translation>
        </message>
        <message>
            <source>correct its configuration, then restart it</source>
            <translation>corrija a configuração dele e reinicie-o</translation>
        </message>
        <message>
            <source>correct its spelling or take it out; known {table}are: {known}</source>
            <translation>corrija a grafia ou retire; as conhecidas {table}são: {known}</translation>
        </message>
        <message>
            <source>correct that</source>
            <translation>corrija isso</translation>
        </message>
        <message>
            <source>correct that key</source>
            <translation>corrija essa chave</translation>
        </message>
        <message>
            <source>correct that line</source>
            <translation>corrija essa linha</translation>
        </message>
        <message>
            <source>correct that line of the program</source>
            <translation>corrija essa linha do programa</translation>
        </message>
        <message>
            <source>correct that one first</source>
            <translation>corrija antes aquele</translation>
        </message>
        <message>
            <source>correct that program, then home the machine</source>
            <translation>corrija esse programa e referencie a máquina</translation>
        </message>
        <message>
            <source>correct that value</source>
            <translation>corrija esse valor</translation>
        </message>
        <message>
            <source>correct the O-words of the macro</source>
            <translation>corrija as palavras O da macro</translation>
        </message>
        <message>
            <source>correct the P word, or the board's settings</source>
            <translation>corrija a palavra P ou as configurações da placa</translation>
        </message>
        <message>
            <source>correct the centre or the end point</source>
            <translation>corrija o centro ou o ponto final</translation>
        </message>
        <message>
            <source>correct the comment</source>
            <translation>corrija o comentário</translation>
        </message>
        <message>
            <source>correct the diameters or pitch_mm</source>
            <translation>corrija os diâmetros ou pitch_mm</translation>
        </message>
        <message>
            <source>correct the drawing's unit, or take out what is drawn many times</source>
            <translation>corrija a unidade do desenho, ou retire o que está desenhado muitas vezes</translation>
        </message>
        <message>
            <source>correct the drawing's unit, or take out what is drawn twice</source>
            <translation>corrija a unidade do desenho, ou retire o que está desenhado duas vezes</translation>
        </message>
        <message>
            <source>correct the end</source>
            <translation>corrija o fim</translation>
        </message>
        <message>
            <source>correct the entry</source>
            <translation>corrija o registro</translation>
        </message>
        <message>
            <source>correct the expression</source>
            <translation>corrija a expressão</translation>
        </message>
        <message>
            <source>correct the expression in that line</source>
            <translation>corrija a expressão dessa linha</translation>
        </message>
        <message>
            <source>correct the file's name</source>
            <translation>corrija o nome do arquivo</translation>
        </message>
        <message>
            <source>correct the file, or export it as STEP</source>
            <translation>corrija o arquivo ou exporte-o como STEP</translation>
        </message>
        <message>
            <source>correct the folder's name</source>
            <translation>corrija o nome da pasta</translation>
        </message>
        <message>
            <source>correct the homing settings ($22 to $27, $44 to $46)</source>
            <translation>corrija as configurações de referenciamento ($22 a $27, $44 a $46)</translation>
        </message>
        <message>
            <source>correct the insert's code</source>
            <translation>corrija o código da pastilha</translation>
        </message>
        <message>
            <source>correct the jog command</source>
            <translation>corrija o comando de jog</translation>
        </message>
        <message>
            <source>correct the number</source>
            <translation>corrija o número</translation>
        </message>
        <message>
            <source>correct the parameter in that line</source>
            <translation>corrija o parâmetro dessa linha</translation>
        </message>
        <message>
            <source>correct the path</source>
            <translation>corrija o caminho</translation>
        </message>
        <message>
            <source>correct the path or the file's permissions</source>
            <translation>corrija o caminho ou as permissões do arquivo</translation>
        </message>
        <message>
            <source>correct the path, or the tool's shape and nose radius</source>
            <translation>corrija o percurso, ou a forma e o raio de ponta da ferramenta</translation>
        </message>
        <message>
            <source>correct the path, the lead-in or the kerf</source>
            <translation>corrija o percurso, a entrada ou a largura do corte</translation>
        </message>
        <message>
            <source>correct the path, the tool's diameter or the depth</source>
            <translation>corrija a trajetória, o diâmetro da ferramenta ou a profundidade</translation>
        </message>
        <message>
            <source>correct the profile</source>
            <translation>corrija o perfil</translation>
        </message>
        <message>
            <source>correct the program, and check it again</source>
            <translation>corrija o programa e verifique-o de novo</translation>
        </message>
        <message>
            <source>correct the script</source>
            <translation>corrija o script</translation>
        </message>
        <message>
            <source>correct the template's rules</source>
            <translation>corrija as regras do modelo</translation>
        </message>
        <message>
            <source>correct the value or its unit</source>
            <translation>corrija o valor ou a unidade</translation>
        </message>
        <message>
            <source>correct the word before</source>
            <translation>corrija a palavra anterior</translation>
        </message>
        <message>
            <source>correct those that are, and check again</source>
            <translation>corrija os que estão na lista e verifique de novo</translation>
        </message>
        <message>
            <source>correct work zero or program</source>
            <translation>corrija o zero-peça ou o programa</translation>
        </message>
        <message>
            <source>correct work zero or program, then unlock with $X; the position is kept</source>
            <translation>corrija o zero-peça ou o programa e destrave com $X; a posição se mantém</translation>
        </message>
        <message>
            <source>count is no whole number within its bounds</source>
            <translation>a quantidade não é um número inteiro dentro de seus limites</translation>
        </message>
        <message>
            <source>curve {number} has no length</source>
            <translation>a curva {number} não tem comprimento</translation>
        </message>
        <message>
            <source>curve {number} is closed, it has no {side}</source>
            <translation>a curva {number} é fechada, não tem {side}</translation>
        </message>
        <message>
            <source>curve {number} is open, it has no {side}</source>
            <translation>a curva {number} é aberta, não tem {side}</translation>
        </message>
        <message>
            <source>curve {number}, which begins at X{x:.3f} Y{y:.3f}, crosses itself or encloses nothing</source>
            <translation>a curva {number}, que começa em X{x:.3f} Y{y:.3f}, cruza a si mesma ou não encerra nada</translation>
        </message>
        <message>
            <source>curves do not meet</source>
            <translation>as curvas não se encontram</translation>
        </message>
        <message>
            <source>cut always</source>
            <translation>sempre cortadas</translation>
        </message>
        <message>
            <source>cut both in one operation, which leaves the gap standing, or use a smaller tool</source>
            <translation>corte os dois em uma só operação, que deixa o vão intacto, ou use uma ferramenta menor</translation>
        </message>
        <message>
            <source>cut holes before the outline round them, or hold the piece by tabs</source>
            <translation>corte os furos antes do contorno em volta deles, ou segure a peça com pontes</translation>
        </message>
        <message>
            <source>cut in more levels, or take a longer tool</source>
            <translation>usine em mais níveis, ou use uma ferramenta mais longa</translation>
        </message>
        <message>
            <source>cut it before, or hold the piece by tabs</source>
            <translation>corte antes, ou segure a peça com pontes</translation>
        </message>
        <message>
            <source>cut it in one way, or with a machine whose language has M3 and M5</source>
            <translation>corte em um só percurso, ou com uma máquina cuja linguagem tenha M3 e M5</translation>
        </message>
        <message>
            <source>cut on the stock that the moves before it have left, and judged against the shapes of the job</source>
            <translation>cortado no material que os movimentos anteriores deixaram, e julgado pelas formas do trabalho</translation>
        </message>
        <message>
            <source>cut some of the curves in an operation of their own</source>
            <translation>corte algumas das curvas em uma operação própria</translation>
        </message>
        <message>
            <source>cut the kerf test at that feed and add a row to kerf_by_feed</source>
            <translation>corte o teste da largura do corte com esse avanço e acrescente uma linha a kerf_by_feed</translation>
        </message>
        <message>
            <source>cut them together as a pocket, or this one with an operation of its own</source>
            <translation>usine-os juntos como um bolsão, ou este com uma operação própria</translation>
        </message>
        <message>
            <source>cut with a kerf of at most {most_mm:.3f} mm, or draw that place wider</source>
            <translation>corte com largura de no máximo {most_mm:.3f} mm, ou desenhe esse lugar mais largo</translation>
        </message>
        <message>
            <source>cut with a kerf of at most {room_mm:.3f} mm, draw the hole wider than the kerf, or set spot_below_mm above {diameter_mm:.3f} to spot it for drilling</source>
            <translation>corte com uma largura de corte de no máximo {room_mm:.3f} mm, desenhe o furo mais largo que o corte, ou ponha spot_below_mm acima de {diameter_mm:.3f} para marcá-lo para furação</translation>
        </message>
        <message>
            <source>cut {depth:.3g} mm deep at most</source>
            <translation>corte no máximo {depth:.3g} mm de profundidade</translation>
        </message>
        <message>
            <source>cuts {overlap_mm:.3g} mm before the place again</source>
            <translation>corta de novo {overlap_mm:.3g} mm antes do ponto</translation>
        </message>
        <message>
            <source>cx cy</source>
            <translation>cx cy</translation>
        </message>
        <message>
            <source>cx cy r</source>
            <translation>cx cy r</translation>
        </message>
        <message>
            <source>dask.distributed is not installed</source>
            <translation>dask.distributed não está instalado</translation>
        </message>
        <message>
            <source>define it, or put its file beside the program</source>
            <translation>defina-a ou ponha o seu arquivo ao lado do programa</translation>
        </message>
        <message>
            <source>describe it in a [[tool]] table</source>
            <translation>descreva-a em uma tabela [[tool]]</translation>
        </message>
        <message>
            <source>diameters must rise, and each range lead from its least value above 0 to its most</source>
            <translation>os diâmetros têm de crescer, e cada faixa ir do seu menor valor acima de 0 ao maior</translation>
        </message>
        <message>
            <source>does not lie flat</source>
            <translation>não é plano</translation>
        </message>
        <message>
            <source>dog-bones or a smaller tool remove it</source>
            <translation>alívio de cantos ou uma ferramenta menor o tira</translation>
        </message>
        <message>
            <source>draw a circle, or cut it as an elliptical pocket</source>
            <translation>desenhe um círculo ou corte-a como bolsão elíptico</translation>
        </message>
        <message>
            <source>draw an outline that encloses one area</source>
            <translation>desenhe um contorno que encerre uma só área</translation>
        </message>
        <message>
            <source>draw at least two points</source>
            <translation>desenhe ao menos dois pontos</translation>
        </message>
        <message>
            <source>draw circles or points where holes are wanted, or give the places by numbers</source>
            <translation>desenhe círculos ou pontos onde quer furos, ou dê os lugares por números</translation>
        </message>
        <message>
            <source>draw holes as circles, or give points</source>
            <translation>desenhe os furos como círculos ou dê pontos</translation>
        </message>
        <message>
            <source>draw it in a [[shape]] table</source>
            <translation>desenhe-a em uma tabela [[shape]]</translation>
        </message>
        <message>
            <source>draw it joined up</source>
            <translation>desenhe-o emendado</translation>
        </message>
        <message>
            <source>draw it larger, or leave it out</source>
            <translation>desenhe-o maior ou deixe-o de fora</translation>
        </message>
        <message>
            <source>draw it on the XY plane or on one parallel to it</source>
            <translation>desenhe-o no plano XY ou em um paralelo a ele</translation>
        </message>
        <message>
            <source>draw lines, arcs, circles, polylines, ellipses or splines in its model space, on visible layers</source>
            <translation>desenhe linhas, arcos, círculos, polilinhas, elipses ou splines no espaço do modelo, em camadas visíveis</translation>
        </message>
        <message>
            <source>draw one rectangle, its corners rounded alike or not at all, or cut it as a pocket</source>
            <translation>desenhe um só retângulo, com todos os cantos arredondados por igual ou nenhum, ou corte-o como bolsão</translation>
        </message>
        <message>
            <source>draw outlines with an area</source>
            <translation>desenhe contornos com área</translation>
        </message>
        <message>
            <source>draw polylines in place of single lines, or split it</source>
            <translation>desenhe polilinhas em vez de linhas soltas, ou divida-o</translation>
        </message>
        <message>
            <source>draw something in it, or choose another drawing</source>
            <translation>desenhe algo nele, ou escolha outro desenho</translation>
        </message>
        <message>
            <source>draw them as points</source>
            <translation>desenhe-os como pontos</translation>
        </message>
        <message>
            <source>draw them {kerf_mm:g} mm apart</source>
            <translation>desenhe-as a {kerf_mm:g} mm uma da outra</translation>
        </message>
        <message>
            <source>draw visible shapes, paths or texts; convert pictures to paths in the drawing program</source>
            <translation>desenhe formas, caminhos ou textos visíveis; converta imagens em caminhos no programa de desenho</translation>
        </message>
        <message>
            <source>drawing sheets</source>
            <translation>desenhando chapas</translation>
        </message>
        <message>
            <source>drawings with the suffix '{suffix}' cannot be read</source>
            <translation>desenhos com o sufixo '{suffix}' não podem ser lidos</translation>
        </message>
        <message>
            <source>drawings with the suffix '{suffix}' cannot be written</source>
            <translation>desenhos com o sufixo '{suffix}' não podem ser escritos</translation>
        </message>
        <message>
            <source>drill first, or turn a tube</source>
            <translation>fure antes, ou torneie um tubo</translation>
        </message>
        <message>
            <source>drill wider</source>
            <translation>fure mais largo</translation>
        </message>
        <message>
            <source>drill {0} mm</source>
            <translation>broca de {0} mm</translation>
        </message>
        <message>
            <source>drive a laser by a controller with grbl's laser mode</source>
            <translation>acione o laser por um controlador com o modo laser do grbl</translation>
        </message>
        <message>
            <source>drop it</source>
            <translation>retire-a</translation>
        </message>
        <message>
            <source>drop the line</source>
            <translation>retire a linha</translation>
        </message>
        <message>
            <source>edge_mm must not be below zero</source>
            <translation>edge_mm não pode ser menor que zero</translation>
        </message>
        <message>
            <source>elements within each other</source>
            <translation>elementos uns dentro dos outros</translation>
        </message>
        <message>
            <source>enable homing ($22=1) or switch soft limits off ($20=0)</source>
            <translation>habilite o referenciamento ($22=1) ou desligue os limites de software ($20=0)</translation>
        </message>
        <message>
            <source>end it at the axis</source>
            <translation>termine-o no eixo</translation>
        </message>
        <message>
            <source>end it in .gif, or install ffmpeg</source>
            <translation>use a extensão .gif, ou instale o ffmpeg</translation>
        </message>
        <message>
            <source>end it in .pdf or .html</source>
            <translation>termine-o em .pdf ou .html</translation>
        </message>
        <message>
            <source>end it with #</source>
            <translation>termine-o com #</translation>
        </message>
        <message>
            <source>end other programs, or lower max_rate_mm_min in the machine's profile</source>
            <translation>feche outros programas, ou diminua max_rate_mm_min no perfil da máquina</translation>
        </message>
        <message>
            <source>end that session as {user}, or remove the file as {user} where none runs any more</source>
            <translation>encerre essa sessão como {user}, ou remova o arquivo como {user} se nenhuma estiver mais em execução</translation>
        </message>
        <message>
            <source>end the move at the axis, at most a nose radius beyond it</source>
            <translation>termine o movimento no eixo, no máximo um raio de ponta além dele</translation>
        </message>
        <message>
            <source>end the name in .json</source>
            <translation>termine o nome em .json</translation>
        </message>
        <message>
            <source>end the name in one of {known}</source>
            <translation>termine o nome em um de {known}</translation>
        </message>
        <message>
            <source>end the profile at the X where the cycle begins, or make I larger</source>
            <translation>termine o perfil no X em que o ciclo começa, ou aumente I</translation>
        </message>
        <message>
            <source>end the tool change and resume, or reset it</source>
            <translation>termine a troca de ferramenta e continue, ou reinicie-a</translation>
        </message>
        <message>
            <source>end the tool change, then resume</source>
            <translation>termine a troca de ferramenta e continue</translation>
        </message>
        <message>
            <source>ends were moved together</source>
            <translation>pontas foram unidas</translation>
        </message>
        <message>
            <source>enter by a helix or ramp, or in the middle of a hole drilled before</source>
            <translation>entre em hélice ou rampa, ou no meio de um furo já aberto</translation>
        </message>
        <message>
            <source>entered here, the program would do something else than when it is run whole</source>
            <translation>retomado aqui, o programa faria algo diferente do que faz quando executado inteiro</translation>
        </message>
        <message>
            <source>enters line {line} at {place}</source>
            <translation>entra na linha {line} em {place}</translation>
        </message>
        <message>
            <source>enters there because {note}</source>
            <translation>entra ali porque {note}</translation>
        </message>
        <message>
            <source>entities with its blocks taken apart</source>
            <translation>entidades com seus blocos desfeitos</translation>
        </message>
        <message>
            <source>entry "plunge"</source>
            <translation>entrada "plunge"</translation>
        </message>
        <message>
            <source>error:{error} {meaning}; {advice}</source>
            <translation>error:{error} {meaning}; {advice}</translation>
        </message>
        <message>
            <source>every line is cut</source>
            <translation>todas as linhas estão cortadas</translation>
        </message>
        <message>
            <source>every line is cut, only the program's end was not seen</source>
            <translation>todas as linhas estão cortadas, só o fim do programa não foi visto</translation>
        </message>
        <message>
            <source>exclusively lock</source>
            <translation>exclusively lock</translation>
        </message>
        <message>
            <source>expand it first: cncstepper convert</source>
            <translation>escreva antes por extenso o que ele faz: cncstepper convert</translation>
        </message>
        <message>
            <source>expand it into plain moves</source>
            <translation>desdobre-o em movimentos simples</translation>
        </message>
        <message>
            <source>export it again</source>
            <translation>exporte-o de novo</translation>
        </message>
        <message>
            <source>export it again, as binary STL</source>
            <translation>exporte-o de novo, como STL binário</translation>
        </message>
        <message>
            <source>export the solid as STEP again</source>
            <translation>exporte o sólido de novo como STEP</translation>
        </message>
        <message>
            <source>expressions in brackets are not part of this dialect</source>
            <translation>expressões entre colchetes não fazem parte deste dialeto</translation>
        </message>
        <message>
            <source>facing takes a right-hand tool for the outside</source>
            <translation>o faceamento usa uma ferramenta externa direita</translation>
        </message>
        <message>
            <source>feed mode set to inverse time</source>
            <translation>modo de avanço: tempo inverso</translation>
        </message>
        <message>
            <source>feed mode set to units per minute</source>
            <translation>modo de avanço: unidades por minuto</translation>
        </message>
        <message>
            <source>feed mode set to units per revolution</source>
            <translation>modo de avanço: unidades por rotação</translation>
        </message>
        <message>
            <source>feed_min_mm_rev must not exceed feed_max_mm_rev</source>
            <translation>feed_min_mm_rev não deve exceder feed_max_mm_rev</translation>
        </message>
        <message>
            <source>feeds a turn became feeds a minute, at the speed that S asks for</source>
            <translation>avanços por rotação viraram avanços por minuto, na rotação que S pede</translation>
        </message>
        <message>
            <source>feeds of inverse time became feeds a minute</source>
            <translation>avanços em tempo inverso viraram avanços por minuto</translation>
        </message>
        <message>
            <source>find the cause, switch the lathe off and on, and set its zero by hand: its position is lost</source>
            <translation>encontre a causa, desligue e ligue o torno e defina o zero à mão: a posição se perdeu</translation>
        </message>
        <message>
            <source>find the cause, then home the machine: its position is lost</source>
            <translation>encontre a causa e referencie a máquina: a posição se perdeu</translation>
        </message>
        <message>
            <source>find the cause, then move the tool to the work zero and set it there: its position is lost</source>
            <translation>encontre a causa, depois leve a ferramenta ao zero-peça e defina-o ali: a posição se perdeu</translation>
        </message>
        <message>
            <source>finish operation:</source>
            <translation>fim da operação:</translation>
        </message>
        <message>
            <source>finish operation: {name}</source>
            <translation>fim da operação: {name}</translation>
        </message>
        <message>
            <source>finish_stepover_mm (ae_acab)</source>
            <translation>finish_stepover_mm (ae_acab)</translation>
        </message>
        <message>
            <source>finish_stepover_mm (ae_acab) is larger than the tool's radius allows</source>
            <translation>finish_stepover_mm (ae_acab) é maior do que o raio da ferramenta permite</translation>
        </message>
        <message>
            <source>finish_{name} leaves nothing to rough</source>
            <translation>finish_{name} não deixa nada para desbastar</translation>
        </message>
        <message>
            <source>fit the scaled curve anew</source>
            <translation>ajuste de novo a curva escalada</translation>
        </message>
        <message>
            <source>flood coolant</source>
            <translation>refrigeração abundante</translation>
        </message>
        <message>
            <source>flute_length_mm must not exceed length_mm</source>
            <translation>flute_length_mm não pode passar de length_mm</translation>
        </message>
        <message>
            <source>formats inside MTEXT are not applied</source>
            <translation>as formatações dentro do MTEXT não são aplicadas</translation>
        </message>
        <message>
            <source>free space on its disk, and resume when the journal is written again</source>
            <translation>libere espaço no disco dele, e continue quando for dito que ele é gravado de novo</translation>
        </message>
        <message>
            <source>free the machine from the switch, then home it</source>
            <translation>solte a máquina do fim de curso e referencie-a</translation>
        </message>
        <message>
            <source>free the probe, reset, then home the machine</source>
            <translation>solte o apalpador, reinicie e referencie a máquina</translation>
        </message>
        <message>
            <source>free {size} MB</source>
            <translation>libere {size} MB</translation>
        </message>
        <message>
            <source>from 1 to {found}</source>
            <translation>de 1 a {found}</translation>
        </message>
        <message>
            <source>from 1 to {runs}</source>
            <translation>de 1 a {runs}</translation>
        </message>
        <message>
            <source>from here on findings of this kind are not listed</source>
            <translation>daqui em diante os achados deste tipo não são listados</translation>
        </message>
        <message>
            <source>from z {0} mm by {1} mm</source>
            <translation>a partir de z {0} mm, por {1} mm</translation>
        </message>
        <message>
            <source>from {begin} at line {first_line}, to {end} at line {last_line}</source>
            <translation>de {begin} na linha {first_line} a {end} na linha {last_line}</translation>
        </message>
        <message>
            <source>front edge at {0} deg</source>
            <translation>aresta da frente a {0} graus</translation>
        </message>
        <message>
            <source>full circles became two arcs</source>
            <translation>círculos completos viraram dois arcos</translation>
        </message>
        <message>
            <source>gap {gap_mm:.3g} mm</source>
            <translation>lacuna de {gap_mm:.3g} mm</translation>
        </message>
        <message>
            <source>gap {gap_mm:g} mm</source>
            <translation>lacuna de {gap_mm:g} mm</translation>
        </message>
        <message>
            <source>gaps were closed</source>
            <translation>vãos foram fechados</translation>
        </message>
        <message>
            <source>give --at once for each copy</source>
            <translation>dê --at uma vez para cada cópia</translation>
        </message>
        <message>
            <source>give --tls-ca, --tls-cert and --tls-key</source>
            <translation>informe --tls-ca, --tls-cert e --tls-key</translation>
        </message>
        <message>
            <source>give /dev/parport0, socket://host:port, a serial device, or record:FILE</source>
            <translation>indique /dev/parport0, socket://host:porta, um dispositivo serial ou record:ARQUIVO</translation>
        </message>
        <message>
            <source>give 2 or 3 numbers</source>
            <translation>dê 2 ou 3 números</translation>
        </message>
        <message>
            <source>give F before it</source>
            <translation>escreva F antes dele</translation>
        </message>
        <message>
            <source>give G64 a P, or follow the exact path with G61</source>
            <translation>dê um P ao G64, ou siga o caminho exato com G61</translation>
        </message>
        <message>
            <source>give I, J and K from the start point of the arc (G91.1)</source>
            <translation>dê I, J e K a partir do ponto inicial do arco (G91.1)</translation>
        </message>
        <message>
            <source>give X,Y,Z in mm, for example 100,70,20</source>
            <translation>dê X,Y,Z em mm, por exemplo 100,70,20</translation>
        </message>
        <message>
            <source>give ^ with G90</source>
            <translation>dê ^ com G90</translation>
        </message>
        <message>
            <source>give a TOML file or one of: {profile_names}</source>
            <translation>dê um arquivo TOML ou um destes: {profile_names}</translation>
        </message>
        <message>
            <source>give a device name or socket://host:port</source>
            <translation>dê um nome de dispositivo ou socket://host:porta</translation>
        </message>
        <message>
            <source>give a diameter above the bore and a length above 0</source>
            <translation>informe um diâmetro maior que o furo e um comprimento acima de 0</translation>
        </message>
        <message>
            <source>give a file that ends in {endings}</source>
            <translation>dê um arquivo que termine em {endings}</translation>
        </message>
        <message>
            <source>give a finite number</source>
            <translation>dê um número finito</translation>
        </message>
        <message>
            <source>give a greater height</source>
            <translation>informe uma altura maior</translation>
        </message>
        <message>
            <source>give a height_mm within the solid, or none for its whole outline</source>
            <translation>dê um height_mm dentro do sólido, ou nenhum para o contorno inteiro</translation>
        </message>
        <message>
            <source>give a line</source>
            <translation>informe uma linha</translation>
        </message>
        <message>
            <source>give a program that cuts along X and Y</source>
            <translation>dê um programa que corte em X e Y</translation>
        </message>
        <message>
            <source>give a smaller file</source>
            <translation>dê um arquivo menor</translation>
        </message>
        <message>
            <source>give a start position of X, Y and Z</source>
            <translation>dê uma posição inicial de X, Y e Z</translation>
        </message>
        <message>
            <source>give a value that the setting allows</source>
            <translation>dê um valor que a configuração permita</translation>
        </message>
        <message>
            <source>give a way of 0.0001 mm or more and a feed above 0</source>
            <translation>dê uma distância de 0,0001 mm ou mais e um avanço acima de 0</translation>
        </message>
        <message>
            <source>give all of them</source>
            <translation>informe todos</translation>
        </message>
        <message>
            <source>give all points one Z and tilt the line by its Placement</source>
            <translation>dê a todos os pontos o mesmo Z e incline a linha pelo seu Posicionamento</translation>
        </message>
        <message>
            <source>give an F word before the first feed move</source>
            <translation>escreva uma palavra F antes do primeiro movimento de avanço</translation>
        </message>
        <message>
            <source>give dwell_s, or use G81</source>
            <translation>indique dwell_s ou use G81</translation>
        </message>
        <message>
            <source>give each material its own number</source>
            <translation>dê a cada material um número próprio</translation>
        </message>
        <message>
            <source>give each outline a drawing or a layer of its own</source>
            <translation>dê a cada contorno um desenho ou uma camada própria</translation>
        </message>
        <message>
            <source>give each row its own number</source>
            <translation>dê a cada linha um número próprio</translation>
        </message>
        <message>
            <source>give either screw_pitch_mm, or belt_pitch_mm and pulley_teeth</source>
            <translation>informe screw_pitch_mm, ou então belt_pitch_mm e pulley_teeth</translation>
        </message>
        <message>
            <source>give every line as many</source>
            <translation>dê a mesma quantidade em todas as linhas</translation>
        </message>
        <message>
            <source>give every row as many</source>
            <translation>dê a mesma quantidade a cada linha</translation>
        </message>
        <message>
            <source>give fewer copies, a smaller gap or a larger --sheet</source>
            <translation>dê menos cópias, uma folga menor ou um --sheet maior</translation>
        </message>
        <message>
            <source>give fewer points</source>
            <translation>dê menos pontos</translation>
        </message>
        <message>
            <source>give heights over the bottom, and the largest as the stock's Z</source>
            <translation>dê alturas acima do fundo, e a maior como Z do bloco</translation>
        </message>
        <message>
            <source>give it another name, or change that one with: cncstepper machine set</source>
            <translation>dê outro nome, ou mude aquele com: cncstepper machine set</translation>
        </message>
        <message>
            <source>give it another number</source>
            <translation>dê a ele outro número</translation>
        </message>
        <message>
            <source>give it or its tool a feed_mm_rev</source>
            <translation>dê a ela ou à sua ferramenta um feed_mm_rev</translation>
        </message>
        <message>
            <source>give its centre</source>
            <translation>dê o seu centro</translation>
        </message>
        <message>
            <source>give its centre with I, J or K</source>
            <translation>dê o seu centro com I, J ou K</translation>
        </message>
        <message>
            <source>give its diameter for X and for Y</source>
            <translation>dê o diâmetro para X e para Y</translation>
        </message>
        <message>
            <source>give its {own_key}</source>
            <translation>informe {own_key} dela</translation>
        </message>
        <message>
            <source>give one of them</source>
            <translation>informe um deles</translation>
        </message>
        <message>
            <source>give parameters {first} to {first2} with the start state, or use G53</source>
            <translation>dê os parâmetros {first} a {first2} com o estado inicial ou use G53</translation>
        </message>
        <message>
            <source>give peck_mm, or use G81</source>
            <translation>dê peck_mm ou use G81</translation>
        </message>
        <message>
            <source>give spindle_rpm or surface_speed_m_min</source>
            <translation>dê spindle_rpm ou surface_speed_m_min</translation>
        </message>
        <message>
            <source>give the arc's centre with I and J</source>
            <translation>dê o centro do arco com I e J</translation>
        </message>
        <message>
            <source>give the height</source>
            <translation>informe a altura</translation>
        </message>
        <message>
            <source>give the job another name</source>
            <translation>dê outro nome ao trabalho</translation>
        </message>
        <message>
            <source>give the material its number and name</source>
            <translation>informe o número e o nome do material</translation>
        </message>
        <message>
            <source>give the number of the run</source>
            <translation>diga em qual das vezes em que ela é executada</translation>
        </message>
        <message>
            <source>give the path of a file</source>
            <translation>dê o caminho de um arquivo</translation>
        </message>
        <message>
            <source>give the stock a greater face_mm</source>
            <translation>dê ao material um face_mm maior</translation>
        </message>
        <message>
            <source>give the stock and the tools</source>
            <translation>informe o bloco e as ferramentas</translation>
        </message>
        <message>
            <source>give the text to be replaced</source>
            <translation>indique o texto a substituir</translation>
        </message>
        <message>
            <source>give the timeline its machine</source>
            <translation>informe a máquina à linha do tempo</translation>
        </message>
        <message>
            <source>give the tool a length_offset_mm, or choose another tool_length for the machine</source>
            <translation>dê à ferramenta um length_offset_mm ou escolha outro tool_length para a máquina</translation>
        </message>
        <message>
            <source>give the tool a {name}</source>
            <translation>dê à ferramenta um {name}</translation>
        </message>
        <message>
            <source>give the tool its flutes</source>
            <translation>informe os dentes da ferramenta</translation>
        </message>
        <message>
            <source>give the tool its length_offset_mm</source>
            <translation>dê à ferramenta o seu length_offset_mm</translation>
        </message>
        <message>
            <source>give the tool table with the start state</source>
            <translation>dê a tabela de ferramentas com o estado inicial</translation>
        </message>
        <message>
            <source>give the tool with the start state</source>
            <translation>dê a ferramenta com o estado inicial</translation>
        </message>
        <message>
            <source>give the whole list or table, for example outputs.coolant=['mist']</source>
            <translation>dê a lista ou tabela inteira, por exemplo outputs.coolant=['mist']</translation>
        </message>
        <message>
            <source>give the work zero and the position, or choose a place after the next rapid</source>
            <translation>informe o zero da peça e a posição, ou escolha um ponto depois do próximo avanço rápido</translation>
        </message>
        <message>
            <source>give the work zero to have the travel checked</source>
            <translation>informe o zero-peça para que o curso seja verificado</translation>
        </message>
        <message>
            <source>give them different homing passes ($44 to $46)</source>
            <translation>dê a eles passadas de referenciamento diferentes ($44 a $46)</translation>
        </message>
        <message>
            <source>give two opposite corners of a rectangle, or three and more of a polygon in their order</source>
            <translation>informe dois cantos opostos de um retângulo, ou três ou mais de um polígono, na ordem</translation>
        </message>
        <message>
            <source>give {key}, or a pattern of circles</source>
            <translation>dê {key} ou um padrão de círculos</translation>
        </message>
        <message>
            <source>given up: the controller was reset or is locked</source>
            <translation>abandonado: o controlador foi reiniciado ou está travado</translation>
        </message>
        <message>
            <source>go back along the cut while a job is held</source>
            <translation>volte ao longo do corte enquanto um trabalho está retido</translation>
        </message>
        <message>
            <source>go back along the cut while a job runs</source>
            <translation>volte ao longo do corte enquanto um trabalho está em execução</translation>
        </message>
        <message>
            <source>go back with `cncstepper back`, and on with `cncstepper back --resume`</source>
            <translation>volte com `cncstepper back` e continue com `cncstepper back --resume`</translation>
        </message>
        <message>
            <source>go line by line while a job runs</source>
            <translation>avance linha por linha enquanto um trabalho está em execução</translation>
        </message>
        <message>
            <source>go on, or stop the job</source>
            <translation>continue, ou pare o trabalho</translation>
        </message>
        <message>
            <source>go round the sheet, or cut with G1</source>
            <translation>contorne a chapa, ou corte com G1</translation>
        </message>
        <message>
            <source>goes down at {plunge_mm_min:g} mm/min</source>
            <translation>desce a {plunge_mm_min:g} mm/min</translation>
        </message>
        <message>
            <source>goes on with</source>
            <translation>continua com</translation>
        </message>
        <message>
            <source>goes to Z {height_mm:.3f} first, straight up (it is not sent while the tool stands higher), then over the place</source>
            <translation>vai primeiro a Z {height_mm:.3f}, reto para cima (não é enviado enquanto a ferramenta estiver mais alta), depois para cima do lugar</translation>
        </message>
        <message>
            <source>grbl follows the exact path always: leave the word out or write G61</source>
            <translation>o grbl sempre segue o percurso exato: omita a palavra ou escreva G61</translation>
        </message>
        <message>
            <source>grbl has G54 to G59</source>
            <translation>o grbl tem G54 a G59</translation>
        </message>
        <message>
            <source>grbl has no canned cycles: write the holes as plain moves</source>
            <translation>o grbl não tem ciclos fixos: escreva os furos como movimentos simples</translation>
        </message>
        <message>
            <source>grbl moves X, Y and Z only</source>
            <translation>o grbl só move X, Y e Z</translation>
        </message>
        <message>
            <source>grblHAL takes arc centres from the start point only (G91.1)</source>
            <translation>o grblHAL só aceita centros de arco a partir do ponto inicial (G91.1)</translation>
        </message>
        <message>
            <source>grip with {force:.4g} N, or cut {depth:.3g} mm deep</source>
            <translation>prenda com {force:.4g} N, ou corte {depth:.3g} mm de profundidade</translation>
        </message>
        <message>
            <source>grooves and parting take a blade</source>
            <translation>canais e sangramento usam um bedame</translation>
        </message>
        <message>
            <source>half a notch</source>
            <translation>meio entalhe</translation>
        </message>
        <message>
            <source>half of both diameters</source>
            <translation>a metade dos dois diâmetros</translation>
        </message>
        <message>
            <source>half of the kerf, {half_mm:g} mm</source>
            <translation>metade da largura do corte, {half_mm:g} mm</translation>
        </message>
        <message>
            <source>half the diameter</source>
            <translation>a metade do diâmetro</translation>
        </message>
        <message>
            <source>half the difference of the diameters</source>
            <translation>a metade da diferença dos diâmetros</translation>
        </message>
        <message>
            <source>has no</source>
            <translation>não tem</translation>
        </message>
        <message>
            <source>heights belong to a stock of the form 'height_field', and to no other</source>
            <translation>alturas pertencem a um bloco da forma 'height_field', e a nenhum outro</translation>
        </message>
        <message>
            <source>heights differ by {rise:.4g} mm</source>
            <translation>as alturas diferem em {rise:.4g} mm</translation>
        </message>
        <message>
            <source>hold it first</source>
            <translation>retenha-o primeiro</translation>
        </message>
        <message>
            <source>hold it first: Ctrl-C at `cncstepper send`</source>
            <translation>pause-o primeiro: Ctrl-C no `cncstepper send`</translation>
        </message>
        <message>
            <source>hold or stop it where it was started, or wait until it has ended</source>
            <translation>pause-o ou pare-o onde foi iniciado, ou espere até terminar</translation>
        </message>
        <message>
            <source>hole {0} of part {1}</source>
            <translation>furo {0} da peça {1}</translation>
        </message>
        <message>
            <source>holes on the axis take a drill</source>
            <translation>furos no eixo usam uma broca</translation>
        </message>
        <message>
            <source>home all axes with $H</source>
            <translation>referencie todos os eixos com $H</translation>
        </message>
        <message>
            <source>home it</source>
            <translation>referencie-a</translation>
        </message>
        <message>
            <source>home it, or set the zero of all axes; only jogging works until then</source>
            <translation>referencie-a ou defina o zero de todos os eixos; até lá só funciona o movimento manual</translation>
        </message>
        <message>
            <source>home the machine</source>
            <translation>referencie a máquina</translation>
        </message>
        <message>
            <source>home the machine ($H), or unlock it ($X) if its position is surely right</source>
            <translation>referencie a máquina ($H), ou destrave-a ($X) se a posição está certa com certeza</translation>
        </message>
        <message>
            <source>home the machine again</source>
            <translation>referencie a máquina de novo</translation>
        </message>
        <message>
            <source>home the machine or set its zero again</source>
            <translation>referencie a máquina ou defina seu zero de novo</translation>
        </message>
        <message>
            <source>home the machine, or move it off the switch by hand</source>
            <translation>referencie a máquina, ou afaste-a do fim de curso à mão</translation>
        </message>
        <message>
            <source>home the machine, or unlock it if it stands where it should</source>
            <translation>referencie a máquina, ou destrave-a se está onde deve</translation>
        </message>
        <message>
            <source>home the machine, or unlock it with $X</source>
            <translation>referencie a máquina, ou destrave-a com $X</translation>
        </message>
        <message>
            <source>home the machine; or move the tool to the work zero, set the zero of all axes there, and send without moving it in between</source>
            <translation>referencie a máquina; ou leve a ferramenta ao zero da peça, defina ali o zero de todos os eixos e envie sem movê-la nesse intervalo</translation>
        </message>
        <message>
            <source>homing can be stopped</source>
            <translation>o referenciamento pode ser parado</translation>
        </message>
        <message>
            <source>homing found no limit switch</source>
            <translation>o referenciamento não encontrou fim de curso</translation>
        </message>
        <message>
            <source>homing is not enabled</source>
            <translation>o referenciamento não está habilitado</translation>
        </message>
        <message>
            <source>homing is set up wrongly</source>
            <translation>o referenciamento está mal configurado</translation>
        </message>
        <message>
            <source>homing was interrupted by a reset</source>
            <translation>o referenciamento foi interrompido por um reset</translation>
        </message>
        <message>
            <source>if it was cutting, the position is unknown: look at the machine, then see {session_file}</source>
            <translation>se estava cortando, a posição é desconhecida: olhe a máquina e depois veja {session_file}</translation>
        </message>
        <message>
            <source>in absolute mode the control drives an axis without a word to 0</source>
            <translation>no modo absoluto o comando leva para 0 um eixo sem palavra</translation>
        </message>
        <message>
            <source>in inverse time every {name} needs its own F above 0</source>
            <translation>em tempo inverso cada {name} precisa do seu próprio F maior que 0</translation>
        </message>
        <message>
            <source>in the operation {span}</source>
            <translation>na operação {span}</translation>
        </message>
        <message>
            <source>incremental coordinates became absolute</source>
            <translation>coordenadas incrementais viraram absolutas</translation>
        </message>
        <message>
            <source>input: two inputs are on {twice}</source>
            <translation>input: duas entradas estão em {twice}</translation>
        </message>
        <message>
            <source>install CNCStepper on every worker, and look at the worker's log</source>
            <translation>instale o CNCStepper em cada processo de trabalho e veja o registro dele</translation>
        </message>
        <message>
            <source>install it again, or choose another font</source>
            <translation>instale-a de novo ou escolha outra fonte</translation>
        </message>
        <message>
            <source>install it for the Python that proves (python -m pip install NAME)</source>
            <translation>instale-o para o Python que verifica (python -m pip install NOME)</translation>
        </message>
        <message>
            <source>install it: python -m pip install distributed</source>
            <translation>instale: python -m pip install distributed</translation>
        </message>
        <message>
            <source>install it: python -m pip install spyrrow</source>
            <translation>instale-o: python -m pip install spyrrow</translation>
        </message>
        <message>
            <source>install it: python -m pip install {package}</source>
            <translation>instale-o: python -m pip install {package}</translation>
        </message>
        <message>
            <source>install the same version on all workers</source>
            <translation>instale a mesma versão em todos os processos de trabalho</translation>
        </message>
        <message>
            <source>install them in one (python -m pip install {packages}), or set {variable} to a Python that has them</source>
            <translation>instale-os em um (python -m pip install {packages}), ou aponte {variable} para um Python que os tenha</translation>
        </message>
        <message>
            <source>is read as a line of its own, in a whole program, where the dialect has subroutines</source>
            <translation>é lido em uma linha própria, em um programa inteiro, onde o dialeto tem sub-rotinas</translation>
        </message>
        <message>
            <source>it appears when that is done</source>
            <translation>ele aparece sozinho quando estiver pronto</translation>
        </message>
        <message>
            <source>it begins with {0}</source>
            <translation>começa com {0}</translation>
        </message>
        <message>
            <source>it changes a file</source>
            <translation>ele altera um arquivo</translation>
        </message>
        <message>
            <source>it closed the connection</source>
            <translation>ele fechou a conexão</translation>
        </message>
        <message>
            <source>it contains a file that no bundle has: {name}</source>
            <translation>contém o que nenhum pacote tem: {name}</translation>
        </message>
        <message>
            <source>it cuts upwards on a helix, as thread mills do, and is entered at its begin, line {begin}</source>
            <translation>o corte sobe em hélice, como fazem as fresas de roscar, e é retomado no seu início, linha {begin}</translation>
        </message>
        <message>
            <source>it does not answer</source>
            <translation>ele não diz nada</translation>
        </message>
        <message>
            <source>it does not begin with M</source>
            <translation>não começa com M</translation>
        </message>
        <message>
            <source>it ended with an error</source>
            <translation>terminou com um erro</translation>
        </message>
        <message>
            <source>it ends at X {end_mm:.4g} Y {end_mm2:.4g}</source>
            <translation>termina em X {end_mm:.4g} Y {end_mm2:.4g}</translation>
        </message>
        <message>
            <source>it ends too early</source>
            <translation>termina cedo demais</translation>
        </message>
        <message>
            <source>it ends with {0}: {1}</source>
            <translation>termina com {0}: {1}</translation>
        </message>
        <message>
            <source>it has a face that belongs to no solid</source>
            <translation>tem uma face que não pertence a nenhum sólido</translation>
        </message>
        <message>
            <source>it has accepted nothing for {limit:g} s</source>
            <translation>não aceita nada há {limit:g} s</translation>
        </message>
        <message>
            <source>it has chains on {known}</source>
            <translation>ele tem cadeias em {known}</translation>
        </message>
        <message>
            <source>it has neither a stroke nor a fill</source>
            <translation>não tem traço nem preenchimento</translation>
        </message>
        <message>
            <source>it has no boundary</source>
            <translation>não tem fronteira</translation>
        </message>
        <message>
            <source>it has no face {0}</source>
            <translation>não tem a fonte {0}</translation>
        </message>
        <message>
            <source>it has no glyph {0}</source>
            <translation>não tem o glifo {0}</translation>
        </message>
        <message>
            <source>it has no outlines</source>
            <translation>não tem contornos</translation>
        </message>
        <message>
            <source>it has no solid</source>
            <translation>não tem nenhum sólido</translation>
        </message>
        <message>
            <source>it has no subroutines</source>
            <translation>não tem sub-rotinas</translation>
        </message>
        <message>
            <source>it has no visible object with a face</source>
            <translation>não tem nenhum objeto visível com uma face</translation>
        </message>
        <message>
            <source>it has no widths</source>
            <translation>não tem larguras</translation>
        </message>
        <message>
            <source>it has no {0}</source>
            <translation>não tem {0}</translation>
        </message>
        <message>
            <source>it has none</source>
            <translation>não tem nenhum</translation>
        </message>
        <message>
            <source>it has them on {names}</source>
            <translation>ele as tem em {names}</translation>
        </message>
        <message>
            <source>it has too many tables of pairs</source>
            <translation>tem tabelas de pares demais</translation>
        </message>
        <message>
            <source>it has {known}</source>
            <translation>ela tem {known}</translation>
        </message>
        <message>
            <source>it has {styles}</source>
            <translation>tem {styles}</translation>
        </message>
        <message>
            <source>it has {ways}</source>
            <translation>tem {ways}</translation>
        </message>
        <message>
            <source>it has: {entries}</source>
            <translation>ele tem: {entries}</translation>
        </message>
        <message>
            <source>it holds more than a bundle does</source>
            <translation>contém mais do que um pacote</translation>
        </message>
        <message>
            <source>it is a device</source>
            <translation>é um dispositivo</translation>
        </message>
        <message>
            <source>it is a folder</source>
            <translation>é uma pasta</translation>
        </message>
        <message>
            <source>it is cut short</source>
            <translation>ele está truncado</translation>
        </message>
        <message>
            <source>it is damaged</source>
            <translation>está danificado</translation>
        </message>
        <message>
            <source>it is empty</source>
            <translation>ele está vazio</translation>
        </message>
        <message>
            <source>it is for {processes}: choose another chart or process</source>
            <translation>ela é para {processes}: escolha outra tabela ou outro processo</translation>
        </message>
        <message>
            <source>it is no BREP file</source>
            <translation>não é um arquivo BREP</translation>
        </message>
        <message>
            <source>it is no STEP file</source>
            <translation>não é um arquivo STEP</translation>
        </message>
        <message>
            <source>it is one program</source>
            <translation>é um só programa</translation>
        </message>
        <message>
            <source>it is too long for its tolerance</source>
            <translation>é longa demais para a sua tolerância</translation>
        </message>
        <message>
            <source>it is uncertain which of several passes was cut, so the earliest possible one is used: line {file_line}, not {file_line2}</source>
            <translation>não se pode dizer com certeza qual de vários passes foi cortado, por isso vale o primeiro que se ajusta: linha {file_line}, não {file_line2}</translation>
        </message>
        <message>
            <source>it is within a way into the cut, which begins at line {file_line}</source>
            <translation>está dentro de uma entrada no corte, que começa na linha {file_line}</translation>
        </message>
        <message>
            <source>it makes a folder</source>
            <translation>ele cria uma pasta</translation>
        </message>
        <message>
            <source>it makes a link</source>
            <translation>ele cria um link</translation>
        </message>
        <message>
            <source>it maps no characters</source>
            <translation>não associa nenhum caractere</translation>
        </message>
        <message>
            <source>it names no operation: choose a line</source>
            <translation>ele não nomeia nenhuma operação: escolha uma linha</translation>
        </message>
        <message>
            <source>it opens a connection</source>
            <translation>ele abre uma conexão</translation>
        </message>
        <message>
            <source>it removed its file</source>
            <translation>ele removeu seu arquivo</translation>
        </message>
        <message>
            <source>it removes a file</source>
            <translation>ele apaga um arquivo</translation>
        </message>
        <message>
            <source>it removes a folder</source>
            <translation>ele apaga uma pasta</translation>
        </message>
        <message>
            <source>it renames a file</source>
            <translation>ele renomeia um arquivo</translation>
        </message>
        <message>
            <source>it resumes without a person</source>
            <translation>continua sozinho</translation>
        </message>
        <message>
            <source>it should be *{summed}</source>
            <translation>deveria ser *{summed}</translation>
        </message>
        <message>
            <source>it shows no solid: give one to show_object, or name it result</source>
            <translation>não mostra nenhum sólido: passe um a show_object ou dê a ele o nome result</translation>
        </message>
        <message>
            <source>it starts a process</source>
            <translation>ele inicia um processo</translation>
        </message>
        <message>
            <source>it starts a program</source>
            <translation>ele inicia um programa</translation>
        </message>
        <message>
            <source>it takes more memory than it may</source>
            <translation>ocupa mais memória do que pode</translation>
        </message>
        <message>
            <source>it takes too long</source>
            <translation>demora demais</translation>
        </message>
        <message>
            <source>it uses '{address}', which is not in the file</source>
            <translation>usa '{address}', que não está no arquivo</translation>
        </message>
        <message>
            <source>it uses itself, or too many others within each other</source>
            <translation>usa a si mesmo, ou elementos demais uns dentro dos outros</translation>
        </message>
        <message>
            <source>it was a restart itself: the first line not certainly cut is the program's {story}</source>
            <translation>ele já era um reinício: a primeira linha não certamente cortada é a {story} do programa</translation>
        </message>
        <message>
            <source>it was compressed or encrypted anew</source>
            <translation>foi comprimido ou cifrado novamente</translation>
        </message>
        <message>
            <source>it would erase the settings: write the settings that you want to change one by one</source>
            <translation>ele esqueceria as configurações: escreva uma a uma as que devem mudar</translation>
        </message>
        <message>
            <source>it writes a file</source>
            <translation>ele escreve um arquivo</translation>
        </message>
        <message>
            <source>item {number}</source>
            <translation>item {number}</translation>
        </message>
        <message>
            <source>its begin is not known</source>
            <translation>o seu início não é conhecido</translation>
        </message>
        <message>
            <source>its boundary is not closed</source>
            <translation>a sua fronteira não está fechada</translation>
        </message>
        <message>
            <source>its controller's process has ended ({status})</source>
            <translation>o processo do controlador terminou ({status})</translation>
        </message>
        <message>
            <source>its directory is too large</source>
            <translation>seu diretório é grande demais</translation>
        </message>
        <message>
            <source>its effect depends on the machine: leave it out</source>
            <translation>o que ela faz depende da máquina: omita-a</translation>
        </message>
        <message>
            <source>its file '{name}' is neither here nor in ../Bit</source>
            <translation>o seu arquivo '{name}' não está aqui nem em ../Bit</translation>
        </message>
        <message>
            <source>its first element is no &lt;svg&gt;</source>
            <translation>o seu primeiro elemento não é &lt;svg&gt;</translation>
        </message>
        <message>
            <source>its head is no object of JSON</source>
            <translation>seu cabeçalho não é um objeto JSON</translation>
        </message>
        <message>
            <source>its head is too large</source>
            <translation>seu cabeçalho é grande demais</translation>
        </message>
        <message>
            <source>its height is no length</source>
            <translation>a sua altura não é um comprimento</translation>
        </message>
        <message>
            <source>its host is not this computer</source>
            <translation>o endereço não é deste computador</translation>
        </message>
        <message>
            <source>its knots and points do not belong together</source>
            <translation>seus nós e pontos não combinam</translation>
        </message>
        <message>
            <source>its knots do not rise</source>
            <translation>seus nós não crescem</translation>
        </message>
        <message>
            <source>its letters lean too far</source>
            <translation>as suas letras inclinam-se demais</translation>
        </message>
        <message>
            <source>its line map is no array of whole numbers</source>
            <translation>seu mapa de linhas não é uma matriz de números inteiros</translation>
        </message>
        <message>
            <source>its lines are too long</source>
            <translation>suas linhas são longas demais</translation>
        </message>
        <message>
            <source>its machine position is not 0</source>
            <translation>a posição de máquina não é 0</translation>
        </message>
        <message>
            <source>its messages do not fit their lines</source>
            <translation>suas mensagens não combinam com suas linhas</translation>
        </message>
        <message>
            <source>its number is above {largest_number}</source>
            <translation>o seu número passa de {largest_number}</translation>
        </message>
        <message>
            <source>its numbers make no curve: {why}</source>
            <translation>seus números não formam uma curva: {why}</translation>
        </message>
        <message>
            <source>its operations are: {known}</source>
            <translation>as operações dele são: {known}</translation>
        </message>
        <message>
            <source>its outline would cross itself</source>
            <translation>o contorno cruzaria a si mesmo</translation>
        </message>
        <message>
            <source>its owner</source>
            <translation>seu proprietário</translation>
        </message>
        <message>
            <source>its program has ended with M02</source>
            <translation>o programa dele terminou com M02</translation>
        </message>
        <message>
            <source>its radius is not above 0</source>
            <translation>o seu raio não é maior que 0</translation>
        </message>
        <message>
            <source>its shape '{kind}' is none of {shapes}</source>
            <translation>a sua forma '{kind}' não é nenhuma de {shapes}</translation>
        </message>
        <message>
            <source>its symbolic links form a circle</source>
            <translation>seus links simbólicos formam um círculo</translation>
        </message>
        <message>
            <source>its transform is damaged</source>
            <translation>a sua transformação está danificada</translation>
        </message>
        <message>
            <source>its weights are not above 0</source>
            <translation>seus pesos não são maiores que 0</translation>
        </message>
        <message>
            <source>its width or height is not above 0</source>
            <translation>a sua largura ou altura não é maior que 0</translation>
        </message>
        <message>
            <source>its {0} has {1} numbers</source>
            <translation>{0} tem {1} números</translation>
        </message>
        <message>
            <source>its {name} are no numbers in bounds</source>
            <translation>{name}: não são números dentro dos limites</translation>
        </message>
        <message>
            <source>its {name} is no number in bounds</source>
            <translation>{name}: não é um número dentro dos limites</translation>
        </message>
        <message>
            <source>jog again if it is still wanted</source>
            <translation>mova de novo se ainda for preciso</translation>
        </message>
        <message>
            <source>jog it down to that height where the way below is free, or restart with the height {here_mm:.1f} (--height), at which it moves over the place directly</source>
            <translation>desça-a à mão até essa altura onde você vê o que há embaixo, ou reinicie com a altura {here_mm:.1f} (--height), da qual ela vai logo para cima do lugar</translation>
        </message>
        <message>
            <source>jog less far</source>
            <translation>mova menos</translation>
        </message>
        <message>
            <source>jog to a place with more room, or test a shorter length</source>
            <translation>mova a um lugar com mais espaço, ou teste um comprimento menor</translation>
        </message>
        <message>
            <source>jog with `cncstepper jog`: it lets the controller give up its lines first</source>
            <translation>mova com `cncstepper jog`: ele primeiro faz o controlador largar as suas linhas</translation>
        </message>
        <message>
            <source>join them into one outline, or move one of them</source>
            <translation>junte-os em um só contorno, ou mova um deles</translation>
        </message>
        <message>
            <source>keep half a kerf beside the part</source>
            <translation>fique meia largura de corte ao lado da peça</translation>
        </message>
        <message>
            <source>kept only if the controller stayed powered and was not reset in motion; a greeting, an alarm or a wrong position shows that it was: then {home}; {until_homed}</source>
            <translation>mantida só se o controlador ficou ligado desde então e não foi reiniciado em movimento; uma saudação, um alarme ou um lugar errado dizem que foi: então {home}; {until_homed}</translation>
        </message>
        <message>
            <source>kerf = kerf used + (S - part + hole - S / 2) / 2</source>
            <translation>largura do corte = largura usada + (S - peça + furo - S / 2) / 2</translation>
        </message>
        <message>
            <source>kerf = kerf used + S - part</source>
            <translation>largura do corte = largura usada + S - peça</translation>
        </message>
        <message>
            <source>kerf_by_feed: feeds must rise from row to row, and kerfs must not</source>
            <translation>kerf_by_feed: de linha em linha os avanços têm de subir, e as larguras do corte não podem subir</translation>
        </message>
        <message>
            <source>kerf_mm is not what this tool cuts</source>
            <translation>kerf_mm não é o que esta ferramenta corta</translation>
        </message>
        <message>
            <source>kind "turning" or "boring"</source>
            <translation>kind "turning" ou "boring"</translation>
        </message>
        <message>
            <source>kind = "boring"</source>
            <translation>kind = "boring"</translation>
        </message>
        <message>
            <source>kind = "drill"</source>
            <translation>kind = "drill"</translation>
        </message>
        <message>
            <source>kind = "parting"</source>
            <translation>kind = "parting"</translation>
        </message>
        <message>
            <source>kind = "threading"</source>
            <translation>kind = "threading"</translation>
        </message>
        <message>
            <source>kind = "turning", hand = "right"</source>
            <translation>kind = "turning", hand = "right"</translation>
        </message>
        <message>
            <source>large cuts are being prepared, once after an installation</source>
            <translation>cortes grandes estão sendo preparados, uma vez após a instalação</translation>
        </message>
        <message>
            <source>larger than {largest_bytes} MB</source>
            <translation>maior que {largest_bytes} MB</translation>
        </message>
        <message>
            <source>laser mode needs a spindle of the kind Laser</source>
            <translation>o modo laser exige um spindle do tipo Laser</translation>
        </message>
        <message>
            <source>laser mode needs a variable spindle output</source>
            <translation>o modo laser exige saída de spindle variável</translation>
        </message>
        <message>
            <source>laser mode: 1 is on, 0 off</source>
            <translation>modo laser: 1 ligado, 0 desligado</translation>
        </message>
        <message>
            <source>last seen</source>
            <translation>visto por último</translation>
        </message>
        <message>
            <source>lay the work in its axes</source>
            <translation>alinhe a peça com os eixos da máquina</translation>
        </message>
        <message>
            <source>lead in and out through scrap</source>
            <translation>entre e saia pelo retalho</translation>
        </message>
        <message>
            <source>lead times speed is more than axis {axis} can: {lead:.4g} mm at {rpm:.4g} rpm</source>
            <translation>avanço por volta vezes rotação é mais do que o eixo {axis} consegue: {lead:.4g} mm a {rpm:.4g} rpm</translation>
        </message>
        <message>
            <source>leads had to be made smaller to stay in the scrap, down to {smallest:.0%} of their size</source>
            <translation>entradas e saídas tiveram de ser diminuídas para ficar na sobra, até {smallest:.0%} do seu tamanho</translation>
        </message>
        <message>
            <source>least_ms must not be above first_ms</source>
            <translation>least_ms não pode ser maior que first_ms</translation>
        </message>
        <message>
            <source>leave '{name}' out, if the machine's operator does it by hand</source>
            <translation>omita '{name}' se o operador da máquina o faz à mão</translation>
        </message>
        <message>
            <source>leave blade_offset_mm out</source>
            <translation>omita blade_offset_mm</translation>
        </message>
        <message>
            <source>leave it out: Marlin has only this mode</source>
            <translation>omita-a: o Marlin só tem este modo</translation>
        </message>
        <message>
            <source>leave less for the finishing pass, or islands remain</source>
            <translation>deixe menos para o passe de acabamento, ou sobram ilhas</translation>
        </message>
        <message>
            <source>leave one ellipse in it and draw the rest elsewhere or as construction lines</source>
            <translation>deixe nele uma elipse e desenhe o resto em outro lugar ou como linhas de construção</translation>
        </message>
        <message>
            <source>leave one ellipse in it, drawn as an ellipse and not as a B-spline</source>
            <translation>deixe nele uma elipse, desenhada como elipse e não como B-spline</translation>
        </message>
        <message>
            <source>leave out</source>
            <translation>omitir</translation>
        </message>
        <message>
            <source>leave part = "holes" out</source>
            <translation>deixe part = "holes" fora</translation>
        </message>
        <message>
            <source>leave so much, ask for fewer tabs, or cut with a narrower kerf: no smaller pierce_mm does</source>
            <translation>deixe tanta sobra, peça menos pontes, ou corte com uma largura menor: nenhum pierce_mm menor basta</translation>
        </message>
        <message>
            <source>leave that setting out</source>
            <translation>deixe essa configuração de fora</translation>
        </message>
        <message>
            <source>leave the N words out</source>
            <translation>omita as palavras N</translation>
        </message>
        <message>
            <source>leave the check mode with $C</source>
            <translation>saia do modo de verificação com $C</translation>
        </message>
        <message>
            <source>leave the joints out</source>
            <translation>deixe as junções de fora</translation>
        </message>
        <message>
            <source>leave the others out</source>
            <translation>omita os outros</translation>
        </message>
        <message>
            <source>leave them out</source>
            <translation>deixe-os de fora</translation>
        </message>
        <message>
            <source>leave {key} out</source>
            <translation>omita {key}</translation>
        </message>
        <message>
            <source>leaves the spindle off, as the program has it there</source>
            <translation>deixa o fuso desligado, como o programa o tem ali</translation>
        </message>
        <message>
            <source>left out</source>
            <translation>omitidas</translation>
        </message>
        <message>
            <source>left out: G61.1, the machine may round the corners</source>
            <translation>omitido: G61.1, a máquina pode arredondar os cantos</translation>
        </message>
        <message>
            <source>left out: G64, the exact path is followed as far as the machine does</source>
            <translation>omitido: G64, o percurso exato é seguido até onde a máquina consegue</translation>
        </message>
        <message>
            <source>left out: the lengths of tools; set the Z zero with each tool</source>
            <translation>omitido: os comprimentos das ferramentas; ajuste o zero de Z com cada ferramenta</translation>
        </message>
        <message>
            <source>left out: {lacks}</source>
            <translation>omitido: {lacks}</translation>
        </message>
        <message>
            <source>left out: {letter}, which never moves; that axis stands at 0</source>
            <translation>omitido: {letter}, que nunca se move; esse eixo fica em 0</translation>
        </message>
        <message>
            <source>lengthen the thread</source>
            <translation>alongue a rosca</translation>
        </message>
        <message>
            <source>lengths of tools went into the coordinates</source>
            <translation>os comprimentos das ferramentas entraram nas coordenadas</translation>
        </message>
        <message>
            <source>less than a kerf is left of a part between two cuts</source>
            <translation>entre dois cortes sobra da peça menos do que a largura do corte</translation>
        </message>
        <message>
            <source>let Z always rise or always fall</source>
            <translation>faça Z sempre subir ou sempre descer</translation>
        </message>
        <message>
            <source>let it plunge at the start of the contour</source>
            <translation>faça-a mergulhar no início do contorno</translation>
        </message>
        <message>
            <source>let it stick out {length:g} mm at most, or support its end</source>
            <translation>deixe no máximo {length:g} mm para fora, ou apoie a ponta</translation>
        </message>
        <message>
            <source>let z never rise along it</source>
            <translation>não deixe z subir ao longo dele</translation>
        </message>
        <message>
            <source>lift the head higher, or go round the piece</source>
            <translation>levante mais o cabeçote, ou contorne a peça</translation>
        </message>
        <message>
            <source>lift the tool before it</source>
            <translation>levante a ferramenta antes dele</translation>
        </message>
        <message>
            <source>lift the tool between them</source>
            <translation>levante a ferramenta entre eles</translation>
        </message>
        <message>
            <source>lift the tool over it, move the clamp or move the shape</source>
            <translation>levante a ferramenta acima dele, mude o grampo de lugar ou desloque a forma</translation>
        </message>
        <message>
            <source>limit {limit}</source>
            <translation>limite {limit}</translation>
        </message>
        <message>
            <source>line numbers begin at 0 or above and grow</source>
            <translation>os números de linha começam em 0 ou acima e crescem</translation>
        </message>
        <message>
            <source>line {0} back</source>
            <translation>linha {0}, volta</translation>
        </message>
        <message>
            <source>line {0}: {1} of {2} not placed: {3}</source>
            <translation>linha {0}: {1} de {2} sem lugar: {3}</translation>
        </message>
        <message>
            <source>line {file_line} is run from its begin</source>
            <translation>a linha {file_line} é executada desde o início</translation>
        </message>
        <message>
            <source>line {file_line} makes several moves and is run from its begin</source>
            <translation>a linha {file_line} faz vários movimentos e é executada desde o início</translation>
        </message>
        <message>
            <source>line {first_line} may not have been begun, line {last} may have been sent</source>
            <translation>a linha {first_line} pode não ter sido começada, a linha {last} pode ter sido enviada</translation>
        </message>
        <message>
            <source>line {first} to {file_line}</source>
            <translation>linha {first} a {file_line}</translation>
        </message>
        <message>
            <source>line {own} here is its line {file_line}</source>
            <translation>a linha {own} aqui é a linha {file_line} dele</translation>
        </message>
        <message>
            <source>line {place} of the journal is damaged</source>
            <translation>a linha {place} do diário está danificada</translation>
        </message>
        <message>
            <source>line {place} of the journal is not the one that was written there</source>
            <translation>a linha {place} do diário não é a que foi gravada ali</translation>
        </message>
        <message>
            <source>lines of '{drawing}' that are not whole circles, so that no hole is drilled: {lines}</source>
            <translation>linhas de '{drawing}' que não são círculos inteiros e não pedem furos: {lines}</translation>
        </message>
        <message>
            <source>lines with / are {word}: no switch deletes them any more</source>
            <translation>linhas com / estão {word}: nenhuma chave as omite mais</translation>
        </message>
        <message>
            <source>load the module ppdev, and give your user access to the device</source>
            <translation>carregue o módulo ppdev e dê ao seu usuário acesso ao dispositivo</translation>
        </message>
        <message>
            <source>log in again</source>
            <translation>entre de novo</translation>
        </message>
        <message>
            <source>log in as a user with that permission</source>
            <translation>entre como um usuário que possa fazê-lo</translation>
        </message>
        <message>
            <source>log in first</source>
            <translation>entre antes</translation>
        </message>
        <message>
            <source>look at cable, shielding and grounding; the part may be cut where it should not be</source>
            <translation>verifique cabo, blindagem e aterramento; a peça pode estar cortada onde não devia</translation>
        </message>
        <message>
            <source>look at its case, or look in comments too</source>
            <translation>veja maiúsculas e minúsculas, ou procure também nos comentários</translation>
        </message>
        <message>
            <source>look at its name and rights</source>
            <translation>veja seu nome e suas permissões</translation>
        </message>
        <message>
            <source>look at its switches</source>
            <translation>examine os fins de curso</translation>
        </message>
        <message>
            <source>look at motors and drivers, reset, then home the machine</source>
            <translation>verifique motores e drivers, reinicie e referencie a máquina</translation>
        </message>
        <message>
            <source>look at motors and drivers, then reset the controller</source>
            <translation>verifique motores e drivers e reinicie o controlador</translation>
        </message>
        <message>
            <source>look at spindle and inverter, reset, then home the machine</source>
            <translation>verifique spindle e inversor, reinicie e referencie a máquina</translation>
        </message>
        <message>
            <source>look at spindle and inverter, then home the machine</source>
            <translation>verifique spindle e inversor e referencie a máquina</translation>
        </message>
        <message>
            <source>look at the Bluetooth settings</source>
            <translation>verifique as configurações de Bluetooth</translation>
        </message>
        <message>
            <source>look at the controller's file system, then try again</source>
            <translation>verifique o sistema de arquivos do controlador e tente de novo</translation>
        </message>
        <message>
            <source>look at the machine</source>
            <translation>olhe a máquina</translation>
        </message>
        <message>
            <source>look at the machine, and restart the program by hand</source>
            <translation>olhe a máquina e reinicie o programa à mão</translation>
        </message>
        <message>
            <source>look at the memory card, then try again</source>
            <translation>verifique o cartão de memória e tente de novo</translation>
        </message>
        <message>
            <source>look at the network of the controller</source>
            <translation>verifique a rede do controlador</translation>
        </message>
        <message>
            <source>look at this drawing alone: cncstepper job</source>
            <translation>examine só este desenho: cncstepper job</translation>
        </message>
        <message>
            <source>look for a pendant or another program that is connected, set the zero again, then send again</source>
            <translation>procure um pendente ou outro programa conectado, defina o zero de novo e envie outra vez</translation>
        </message>
        <message>
            <source>look that the tool is off, and start the job again</source>
            <translation>veja se a ferramenta está desligada e inicie o trabalho de novo</translation>
        </message>
        <message>
            <source>look the number up in the documentation of the controller's version</source>
            <translation>procure o número na documentação da versão do controlador</translation>
        </message>
        <message>
            <source>look whether the file is whole</source>
            <translation>veja se o arquivo está completo</translation>
        </message>
        <message>
            <source>look which machine moves, and stop it there</source>
            <translation>veja qual máquina se move e pare-a ali</translation>
        </message>
        <message>
            <source>lower F, or turn the spindle faster</source>
            <translation>diminua F, ou aumente a rotação do spindle</translation>
        </message>
        <message>
            <source>lower F; the machine will take longer than the feed says</source>
            <translation>diminua F; a máquina levará mais tempo do que o avanço indica</translation>
        </message>
        <message>
            <source>lower ap_mm</source>
            <translation>diminua ap_mm</translation>
        </message>
        <message>
            <source>lower spindle_rpm</source>
            <translation>diminua spindle_rpm</translation>
        </message>
        <message>
            <source>lower steps/mm or maximum rate</source>
            <translation>diminua os passos/mm ou a velocidade máxima</translation>
        </message>
        <message>
            <source>lower taper_deg or its length</source>
            <translation>reduza taper_deg ou o comprimento</translation>
        </message>
        <message>
            <source>lower the feed</source>
            <translation>diminua o avanço</translation>
        </message>
        <message>
            <source>lower the feed here, or the axis' rate and acceleration in controller and profile</source>
            <translation>diminua o avanço aqui, ou a velocidade e a aceleração do eixo no controlador e no perfil</translation>
        </message>
        <message>
            <source>lower the feed of that line</source>
            <translation>diminua o avanço dessa linha</translation>
        </message>
        <message>
            <source>lower the feed, or turn the spindle faster</source>
            <translation>baixe o avanço ou gire o spindle mais rápido</translation>
        </message>
        <message>
            <source>lower the stepover, enter by a helix, or leave less in the corners</source>
            <translation>diminua a penetração de trabalho, entre em hélice, ou deixe menos material nos cantos</translation>
        </message>
        <message>
            <source>machines with more than three axes are not written for Mach yet</source>
            <translation>ainda não se escrevem programas de Mach para máquinas com mais de três eixos</translation>
        </message>
        <message>
            <source>machines with more than three axes are not written in this dialect</source>
            <translation>neste dialeto não se escrevem programas para máquinas com mais de três eixos</translation>
        </message>
        <message>
            <source>make D smaller</source>
            <translation>diminua D</translation>
        </message>
        <message>
            <source>make Q larger</source>
            <translation>aumente Q</translation>
        </message>
        <message>
            <source>make a profile of your own from it: cncstepper machine new NAME --from FILE</source>
            <translation>faça dele um perfil seu: cncstepper machine new NAME --from FILE</translation>
        </message>
        <message>
            <source>make finish_{name} smaller</source>
            <translation>diminua finish_{name}</translation>
        </message>
        <message>
            <source>make it again</source>
            <translation>refaça-o</translation>
        </message>
        <message>
            <source>make it shorter</source>
            <translation>encurte-o</translation>
        </message>
        <message>
            <source>make it smaller</source>
            <translation>diminua-o</translation>
        </message>
        <message>
            <source>make it smaller, or islands remain</source>
            <translation>diminua-a, ou sobram ilhas</translation>
        </message>
        <message>
            <source>make its side longer</source>
            <translation>aumente o lado dele</translation>
        </message>
        <message>
            <source>make one object of each layer</source>
            <translation>faça um objeto de cada camada</translation>
        </message>
        <message>
            <source>make resolution_mm larger</source>
            <translation>aumente resolution_mm</translation>
        </message>
        <message>
            <source>make room on the disk of {folder}, and see that you may write there; then send again</source>
            <translation>libere espaço no disco de {folder} e verifique se você pode gravar ali; depois envie de novo</translation>
        </message>
        <message>
            <source>make room on the disk of {parent}, and see that you may write there</source>
            <translation>libere espaço no disco de {parent}, e veja se você pode gravar ali</translation>
        </message>
        <message>
            <source>make several jobs of this one</source>
            <translation>faça vários trabalhos deste</translation>
        </message>
        <message>
            <source>make several texts of it</source>
            <translation>divida-o em vários textos</translation>
        </message>
        <message>
            <source>make spacing_mm larger</source>
            <translation>aumente spacing_mm</translation>
        </message>
        <message>
            <source>make stepover_mm larger</source>
            <translation>aumente stepover_mm</translation>
        </message>
        <message>
            <source>make sure that the axes are at rest, check cable and grounding, and home again</source>
            <translation>veja se os eixos estão parados, verifique o cabo e o aterramento e referencie a máquina de novo</translation>
        </message>
        <message>
            <source>make the corner radius smaller</source>
            <translation>diminua o raio de canto</translation>
        </message>
        <message>
            <source>make the job again</source>
            <translation>gere o trabalho de novo</translation>
        </message>
        <message>
            <source>make the lead-in longer</source>
            <translation>aumente a entrada</translation>
        </message>
        <message>
            <source>make the leads or the tool smaller, move the parts apart, or do without leads</source>
            <translation>diminua as entradas e saídas ou a ferramenta, afaste as peças ou fique sem entradas e saídas</translation>
        </message>
        <message>
            <source>make the list shorter</source>
            <translation>encurte a lista</translation>
        </message>
        <message>
            <source>make the passes, the levels, the resolution or the entry angle larger</source>
            <translation>aumente os passes, os níveis, a resolução ou o ângulo de entrada</translation>
        </message>
        <message>
            <source>make the program again</source>
            <translation>gere o programa de novo</translation>
        </message>
        <message>
            <source>make the program smaller, split it, or use a larger machine</source>
            <translation>diminua o programa, divida-o ou use uma máquina maior</translation>
        </message>
        <message>
            <source>make the tabs narrower or the tool smaller, or cut without tabs</source>
            <translation>estreite as pontes ou diminua a ferramenta, ou corte sem pontes</translation>
        </message>
        <message>
            <source>make the text smaller, move its start, or lengthen the curve</source>
            <translation>diminua o texto, mude o seu início ou alongue a curva</translation>
        </message>
        <message>
            <source>make them coincide, or keep them {small_mm:g} mm apart</source>
            <translation>faça-os coincidir ou mantenha-os a {small_mm:g} mm um do outro</translation>
        </message>
        <message>
            <source>make them lower</source>
            <translation>baixe-as</translation>
        </message>
        <message>
            <source>make {name} larger</source>
            <translation>aumente {name}</translation>
        </message>
        <message>
            <source>making and proving</source>
            <translation>criando e provando</translation>
        </message>
        <message>
            <source>margin {margin_mm:g} mm</source>
            <translation>margem de {margin_mm:g} mm</translation>
        </message>
        <message>
            <source>marks_for names '{title}', which is no rule with a sheet_cut</source>
            <translation>marks_for nomeia '{title}', que não é uma regra com sheet_cut</translation>
        </message>
        <message>
            <source>material is left on profile '{name}' where its tools reach</source>
            <translation>sobra material no perfil '{name}' onde as ferramentas alcançam</translation>
        </message>
        <message>
            <source>material is left where it should be removed{islands}</source>
            <translation>sobra material onde deveria ser removido{islands}</translation>
        </message>
        <message>
            <source>material stays in {gaps} gap(s) between walls that are narrower than the tool, the deepest one before X{x:.3f} Y{y:.3f}; a smaller tool removes it</source>
            <translation>fica material em {gaps} fresta(s) entre paredes mais estreita(s) que a ferramenta, a mais funda diante de X{x:.3f} Y{y:.3f}; uma ferramenta menor o remove</translation>
        </message>
        <message>
            <source>material that is cut off</source>
            <translation>o que é cortado</translation>
        </message>
        <message>
            <source>material {number} has no {key}</source>
            <translation>o material {number} não tem {key}</translation>
        </message>
        <message>
            <source>measure again, or correct steps_per_mm first</source>
            <translation>meça de novo, ou corrija antes steps_per_mm</translation>
        </message>
        <message>
            <source>measure again; where it is true, work steps_per_mm out with: cncstepper axis</source>
            <translation>meça de novo; se for verdade, calcule steps_per_mm com: cncstepper axis</translation>
        </message>
        <message>
            <source>measure the width of its cut, or leave kerf_mm out</source>
            <translation>meça a largura do corte dela, ou omita kerf_mm</translation>
        </message>
        <message>
            <source>mend one of them, or select others</source>
            <translation>corrija um deles, ou selecione outros</translation>
        </message>
        <message>
            <source>mend that object first</source>
            <translation>corrija antes esse objeto</translation>
        </message>
        <message>
            <source>mend the file that it was read from, where that is not meant</source>
            <translation>corrija o arquivo de onde foi lido, onde não for essa a intenção</translation>
        </message>
        <message>
            <source>mini-lathe B</source>
            <translation>minitorno B</translation>
        </message>
        <message>
            <source>mist coolant</source>
            <translation>refrigeração por névoa</translation>
        </message>
        <message>
            <source>more of the {tool} tool's rim is in the material than it may</source>
            <translation>o ângulo de contato da ferramenta {tool} com o material é maior que o permitido</translation>
        </message>
        <message>
            <source>more than</source>
            <translation>mais de</translation>
        </message>
        <message>
            <source>more than a million million</source>
            <translation>mais de um trilhão</translation>
        </message>
        <message>
            <source>more than a million of anything is a slip</source>
            <translation>mais de um milhão de qualquer coisa é um engano</translation>
        </message>
        <message>
            <source>more than ten times the whole is a slip</source>
            <translation>mais de dez vezes o todo é um engano</translation>
        </message>
        <message>
            <source>more than {most} lines</source>
            <translation>mais de {most} linhas</translation>
        </message>
        <message>
            <source>more than {radius:g} mm</source>
            <translation>mais de {radius:g} mm</translation>
        </message>
        <message>
            <source>more than {way} steps</source>
            <translation>mais de {way} passos</translation>
        </message>
        <message>
            <source>motion mode set to none</source>
            <translation>modo de movimento: nenhum</translation>
        </message>
        <message>
            <source>mount it first</source>
            <translation>monte-o antes</translation>
        </message>
        <message>
            <source>move it {in_mm:.3f} mm inwards, or take a larger sheet</source>
            <translation>desloque-a {in_mm:.3f} mm para dentro, ou use uma chapa maior</translation>
        </message>
        <message>
            <source>move one of the corners</source>
            <translation>mova um dos cantos</translation>
        </message>
        <message>
            <source>move other axes before</source>
            <translation>mova os outros eixos antes</translation>
        </message>
        <message>
            <source>move the holes apart, join them, or draw a slit yourself</source>
            <translation>afaste os furos, una-os, ou desenhe você mesmo uma fenda</translation>
        </message>
        <message>
            <source>move the line away from the part, or leave it out</source>
            <translation>afaste a linha da peça, ou deixe-a de fora</translation>
        </message>
        <message>
            <source>move the machine off it, then home</source>
            <translation>afaste a máquina dele e referencie</translation>
        </message>
        <message>
            <source>move the machine off the switch, reset, then home it</source>
            <translation>afaste a máquina do fim de curso, reinicie e referencie-a</translation>
        </message>
        <message>
            <source>move the parts farther apart, enter from another edge, or use a thinner wire</source>
            <translation>afaste mais as peças, entre por outra borda, ou use um fio mais fino</translation>
        </message>
        <message>
            <source>move the parts farther apart, or cut them in several operations</source>
            <translation>afaste mais as peças, ou corte-as em várias operações</translation>
        </message>
        <message>
            <source>move the shape inwards, or take a larger sheet</source>
            <translation>desloque a forma para dentro, ou use uma chapa maior</translation>
        </message>
        <message>
            <source>move the shape or the work zero, or take larger stock</source>
            <translation>mova a forma ou o zero-peça, ou use um bloco maior</translation>
        </message>
        <message>
            <source>move the slider to start it again</source>
            <translation>mova o controle deslizante para iniciá-lo de novo</translation>
        </message>
        <message>
            <source>move the tool to the work zero and set it there</source>
            <translation>leve a ferramenta ao zero da peça e defina-o ali</translation>
        </message>
        <message>
            <source>move the tool to the work zero and set it there before its next move</source>
            <translation>leve a ferramenta ao zero-peça e defina-o ali antes do próximo movimento</translation>
        </message>
        <message>
            <source>move the work zero {word} the {name} axis or make the program smaller</source>
            <translation>mova o zero-peça ({word}) no eixo {name} ou diminua o programa</translation>
        </message>
        <message>
            <source>move them or the work zero</source>
            <translation>mova-os ou mova o zero da peça</translation>
        </message>
        <message>
            <source>move them {more_mm:.3f} mm farther apart, or cut with a kerf of at most {gap_mm:.3f} mm</source>
            <translation>afaste-as mais {more_mm:.3f} mm, ou corte com largura de no máximo {gap_mm:.3f} mm</translation>
        </message>
        <message>
            <source>move there first with absolute coordinates, or give the start</source>
            <translation>vá antes até lá com coordenadas absolutas, ou informe o início</translation>
        </message>
        <message>
            <source>move there with G90 first</source>
            <translation>vá antes até lá com G90</translation>
        </message>
        <message>
            <source>move {letter} on a line of its own</source>
            <translation>mova {letter} em uma linha própria</translation>
        </message>
        <message>
            <source>must be {number} from {words}</source>
            <translation>deve ser {number} de {words}</translation>
        </message>
        <message>
            <source>name X and Y in a rapid above the stock first</source>
            <translation>indique antes X e Y em um rápido acima do bloco</translation>
        </message>
        <message>
            <source>name a file that ends in .ttf, .otf, .ttc or .otc; unpack a web font first</source>
            <translation>indique um arquivo que termine em .ttf, .otf, .ttc ou .otc; descompacte antes uma fonte da web</translation>
        </message>
        <message>
            <source>name a file that is not there yet, in a folder that you may write in</source>
            <translation>dê o nome de um arquivo que ainda não existe, numa pasta em que você pode gravar</translation>
        </message>
        <message>
            <source>name a line that was cut before this one</source>
            <translation>indique uma linha que foi cortada antes desta</translation>
        </message>
        <message>
            <source>name a new file, or one that pulses were recorded in</source>
            <translation>indique um arquivo novo, ou um em que já se gravaram pulsos</translation>
        </message>
        <message>
            <source>name a parallel port (/dev/parport0), or a text file with the numbers of the pins that are high</source>
            <translation>indique uma porta paralela (/dev/parport0), ou um arquivo de texto com os números dos pinos em nível alto</translation>
        </message>
        <message>
            <source>name a parallel port, a serial device, socket://host:port, or record:FILE</source>
            <translation>indique uma porta paralela, um dispositivo serial, socket://host:porta ou record:ARQUIVO</translation>
        </message>
        <message>
            <source>name a profile with both</source>
            <translation>escolha um perfil com ambos</translation>
        </message>
        <message>
            <source>name a script with the suffix .py</source>
            <translation>indique um script com o sufixo .py</translation>
        </message>
        <message>
            <source>name a shape of one curve</source>
            <translation>indique uma forma de uma só curva</translation>
        </message>
        <message>
            <source>name an axis that it has</source>
            <translation>indique um eixo que ela tenha</translation>
        </message>
        <message>
            <source>name another machine</source>
            <translation>indique outra máquina</translation>
        </message>
        <message>
            <source>name both axes</source>
            <translation>indique os dois eixos</translation>
        </message>
        <message>
            <source>name it</source>
            <translation>indique-a</translation>
        </message>
        <message>
            <source>name it once</source>
            <translation>nomeie-a uma só vez</translation>
        </message>
        <message>
            <source>name its insert, or its angles and nose radius</source>
            <translation>informe a pastilha, ou os ângulos e o raio de ponta</translation>
        </message>
        <message>
            <source>name one</source>
            <translation>indique um</translation>
        </message>
        <message>
            <source>name one of them</source>
            <translation>nomeie uma delas</translation>
        </message>
        <message>
            <source>name one of {names}</source>
            <translation>indique um entre {names}</translation>
        </message>
        <message>
            <source>name one of: {known}</source>
            <translation>nomeie uma de: {known}</translation>
        </message>
        <message>
            <source>name one that the system has: {families}</source>
            <translation>indique uma que o sistema tenha: {families}</translation>
        </message>
        <message>
            <source>name the machine (--machine)</source>
            <translation>indique a máquina (--machine)</translation>
        </message>
        <message>
            <source>name the machine profile of the table that is wired to it (controller = "thesis-a")</source>
            <translation>indique o perfil da máquina ligada a ela (controller = "thesis-a")</translation>
        </message>
        <message>
            <source>name the material, or write a [[tool]]</source>
            <translation>indique o material, ou escreva um [[tool]]</translation>
        </message>
        <message>
            <source>named parameters are not part of this dialect</source>
            <translation>parâmetros com nome não fazem parte deste dialeto</translation>
        </message>
        <message>
            <source>nested too deeply</source>
            <translation>aninhado fundo demais</translation>
        </message>
        <message>
            <source>next is line {line}: {text}</source>
            <translation>a próxima é a linha {line}: {text}</translation>
        </message>
        <message>
            <source>nichrome 0.4 mm</source>
            <translation>nicromo 0,4 mm</translation>
        </message>
        <message>
            <source>no arc or wire stands at more than 10 kV</source>
            <translation>nenhum arco ou fio fica a mais de 10 kV</translation>
        </message>
        <message>
            <source>no axis is set up for homing</source>
            <translation>nenhum eixo está configurado para referenciamento</translation>
        </message>
        <message>
            <source>no axis lifts a tool by more than 10 m</source>
            <translation>nenhum eixo levanta uma ferramenta mais de 10 m</translation>
        </message>
        <message>
            <source>no axis pushes with more than 100 t</source>
            <translation>nenhum eixo empurra com mais de 100 t</translation>
        </message>
        <message>
            <source>no axis runs faster than 16 m/s</source>
            <translation>nenhum eixo corre mais que 16 m/s</translation>
        </message>
        <message>
            <source>no axis speeds up by more than 100 g</source>
            <translation>nenhum eixo acelera mais que 100 g</translation>
        </message>
        <message>
            <source>no closed curves at that distance were found</source>
            <translation>não se encontraram curvas fechadas a essa distância</translation>
        </message>
        <message>
            <source>no code on this line uses the word {letter}</source>
            <translation>nenhum código desta linha usa a palavra {letter}</translation>
        </message>
        <message>
            <source>no conversion makes this a program for {dialect_named}: {error}</source>
            <translation>nenhuma conversão faz deste um programa para {dialect_named}: {error}</translation>
        </message>
        <message>
            <source>no cutter's edge runs faster than 170 m/s</source>
            <translation>nenhum gume corre mais que 170 m/s</translation>
        </message>
        <message>
            <source>no drive changes its acceleration faster</source>
            <translation>nenhum acionamento muda a aceleração mais depressa</translation>
        </message>
        <message>
            <source>no encoder counts more in a turn</source>
            <translation>nenhum encoder conta mais numa volta</translation>
        </message>
        <message>
            <source>no encoder for '{file}' is installed</source>
            <translation>não há codificador instalado para '{file}'</translation>
        </message>
        <message>
            <source>no feed rate was set</source>
            <translation>nenhum avanço foi definido</translation>
        </message>
        <message>
            <source>no file system is mounted</source>
            <translation>nenhum sistema de arquivos está montado</translation>
        </message>
        <message>
            <source>no gear turns ten thousand times faster</source>
            <translation>nenhuma engrenagem gira dez mil vezes mais depressa</translation>
        </message>
        <message>
            <source>no identity of a port: {content}</source>
            <translation>não é a identidade de uma porta: {content}</translation>
        </message>
        <message>
            <source>no input may be read</source>
            <translation>nenhuma entrada pode ser lida</translation>
        </message>
        <message>
            <source>no jet is driven by more than 10 kbar</source>
            <translation>nenhum jato trabalha com mais de 10 kbar</translation>
        </message>
        <message>
            <source>no job is held</source>
            <translation>nenhum trabalho está retido</translation>
        </message>
        <message>
            <source>no job runs</source>
            <translation>nenhum trabalho está em execução</translation>
        </message>
        <message>
            <source>no machine holds a tenth of a micron, and above 10 mm nothing is held</source>
            <translation>nenhuma máquina mantém um décimo de mícron, e acima de 10 mm nada é mantido</translation>
        </message>
        <message>
            <source>no material is stiffer than diamond</source>
            <translation>nenhum material é mais rígido que o diamante</translation>
        </message>
        <message>
            <source>no material needs more than 100 kN on a square millimetre of chip</source>
            <translation>nenhum material exige mais de 100 kN por milímetro quadrado de cavaco</translation>
        </message>
        <message>
            <source>no memory card is mounted</source>
            <translation>nenhum cartão de memória está montado</translation>
        </message>
        <message>
            <source>no modes are kept here</source>
            <translation>não há modos guardados aqui</translation>
        </message>
        <message>
            <source>no move of line {line} lies on the way back</source>
            <translation>nenhum movimento da linha {line} fica no caminho de volta</translation>
        </message>
        <message>
            <source>no operation, or more than one, is called '{name}'</source>
            <translation>nenhuma operação, ou mais de uma, se chama '{name}'</translation>
        </message>
        <message>
            <source>no output may be set</source>
            <translation>nenhuma saída pode ser mudada</translation>
        </message>
        <message>
            <source>no parallel curve that far inside</source>
            <translation>não há curva paralela tão para dentro</translation>
        </message>
        <message>
            <source>no pass is narrower than a micron or wider than 10 m</source>
            <translation>nenhum passe é mais estreito que um mícron ou mais largo que 10 m</translation>
        </message>
        <message>
            <source>no position may be stored</source>
            <translation>nenhuma posição pode ser guardada</translation>
        </message>
        <message>
            <source>no process has it any more: remove the file as {user}</source>
            <translation>nenhum processo o usa mais: remova o arquivo como {user}</translation>
        </message>
        <message>
            <source>no process, or no port</source>
            <translation>sem processo ou sem porta</translation>
        </message>
        <message>
            <source>no rapid leads to this way, and backwards it does not begin where the one before ends</source>
            <translation>nenhum rápido leva a este trecho, e ao contrário ele não começa onde o anterior termina</translation>
        </message>
        <message>
            <source>no rapid of the program says at what height the tool may cross the work</source>
            <translation>nenhum avanço rápido do programa diz a que altura a ferramenta pode cruzar a peça</translation>
        </message>
        <message>
            <source>no rates in the machine's profile</source>
            <translation>sem tarifas no perfil da máquina</translation>
        </message>
        <message>
            <source>no regular file</source>
            <translation>nenhum arquivo comum</translation>
        </message>
        <message>
            <source>no rule of the template takes a chain of the drawing</source>
            <translation>nenhuma regra do modelo pega uma cadeia do desenho</translation>
        </message>
        <message>
            <source>no rule of the template takes chains of the drawing: {counts}</source>
            <translation>nenhuma regra do modelo pega cadeias do desenho: {counts}</translation>
        </message>
        <message>
            <source>no rule takes {0} chains of the drawing</source>
            <translation>nenhuma regra toma {0} cadeias do desenho</translation>
        </message>
        <message>
            <source>no scheduler answers: {error}</source>
            <translation>nenhum escalonador responde: {error}</translation>
        </message>
        <message>
            <source>no screw and rotor has more</source>
            <translation>nenhum fuso com rotor tem mais</translation>
        </message>
        <message>
            <source>no spindle of a lathe or mill has more than 1 MW</source>
            <translation>nenhum fuso de torno ou fresadora tem mais de 1 MW</translation>
        </message>
        <message>
            <source>no spindle turns faster than a million a minute</source>
            <translation>nenhum fuso gira mais que um milhão de voltas por minuto</translation>
        </message>
        <message>
            <source>no spline is cut in inverse time</source>
            <translation>nenhuma spline é cortada em tempo inverso</translation>
        </message>
        <message>
            <source>no spline may be cut</source>
            <translation>nenhuma spline pode ser cortada</translation>
        </message>
        <message>
            <source>no step is finer than a micron and no table longer than 100 m</source>
            <translation>nenhum passo é mais fino que um mícron e nenhuma mesa mais longa que 100 m</translation>
        </message>
        <message>
            <source>no stepper motor gives more than 10 kNm</source>
            <translation>nenhum motor de passo dá mais que 10 kNm</translation>
        </message>
        <message>
            <source>no straight slit leads into the hole at X{x:.3f} Y{y:.3f} past the part's other holes</source>
            <translation>nenhuma fenda reta chega ao furo em X{x:.3f} Y{y:.3f} sem atravessar os outros furos da peça</translation>
        </message>
        <message>
            <source>no tab fits on any contour</source>
            <translation>nenhuma ponte cabe em nenhum contorno</translation>
        </message>
        <message>
            <source>no table is longer than 100 m</source>
            <translation>nenhuma mesa é mais longa que 100 m</translation>
        </message>
        <message>
            <source>no token, or no path of a socket</source>
            <translation>sem senha ou sem caminho de um socket</translation>
        </message>
        <message>
            <source>no tool cuts thinner than a micron or deeper than 10 m</source>
            <translation>nenhuma ferramenta corta mais fino que um mícron ou mais fundo que 10 m</translation>
        </message>
        <message>
            <source>no tooth takes more than 10 mm</source>
            <translation>nenhum dente tira mais que 10 mm</translation>
        </message>
        <message>
            <source>no torch or wire draws more than 10 kA</source>
            <translation>nenhuma tocha ou fio puxa mais de 10 kA</translation>
        </message>
        <message>
            <source>no way through the scrap leads to what lies at X{x:.3f} Y{y:.3f}</source>
            <translation>nenhum caminho pelo retalho leva ao que fica em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>none of the selected drawings can be followed</source>
            <translation>nenhum dos desenhos selecionados pode ser seguido</translation>
        </message>
        <message>
            <source>nose radius</source>
            <translation>raio de ponta</translation>
        </message>
        <message>
            <source>nose radius {0} mm</source>
            <translation>raio de ponta {0} mm</translation>
        </message>
        <message>
            <source>nose {0} mm</source>
            <translation>ponta de {0} mm</translation>
        </message>
        <message>
            <source>not a DXF file: {why}</source>
            <translation>não é um arquivo DXF: {why}</translation>
        </message>
        <message>
            <source>not a FreeCAD document</source>
            <translation>não é um documento do FreeCAD</translation>
        </message>
        <message>
            <source>not a JSON file: {error}</source>
            <translation>não é um arquivo JSON: {error}</translation>
        </message>
        <message>
            <source>not a PNG or JPEG picture: {why}</source>
            <translation>não é uma imagem PNG ou JPEG: {why}</translation>
        </message>
        <message>
            <source>not a TOML file: {error}</source>
            <translation>não é um arquivo TOML: {error}</translation>
        </message>
        <message>
            <source>not a TrueType or OpenType font</source>
            <translation>não é uma fonte TrueType ou OpenType</translation>
        </message>
        <message>
            <source>not a curve with xy and bulge: {error}</source>
            <translation>não é uma curva com xy e bulge: {error}</translation>
        </message>
        <message>
            <source>not a file</source>
            <translation>não é um arquivo</translation>
        </message>
        <message>
            <source>not a job to send: {error}</source>
            <translation>não é um trabalho para enviar: {error}</translation>
        </message>
        <message>
            <source>not a line of a material file: '{line}'</source>
            <translation>não é uma linha de arquivo de materiais: '{line}'</translation>
        </message>
        <message>
            <source>not a number: {text}</source>
            <translation>não é um número: {text}</translation>
        </message>
        <message>
            <source>not a parameter of a material's comment</source>
            <translation>não é um parâmetro de comentário de material</translation>
        </message>
        <message>
            <source>not a point: '{line}'</source>
            <translation>não é um ponto: '{line}'</translation>
        </message>
        <message>
            <source>not a status: a vector has other things in it than numbers</source>
            <translation>não é um estado: um vetor contém outra coisa que números</translation>
        </message>
        <message>
            <source>not a status: its {name} is no {kind_name}</source>
            <translation>não é um estado: {name} não é do tipo {kind_name}</translation>
        </message>
        <message>
            <source>not a status: {error}</source>
            <translation>não é um estado: {error}</translation>
        </message>
        <message>
            <source>not a text file</source>
            <translation>não é um arquivo de texto</translation>
        </message>
        <message>
            <source>not a tool bit: it has no shape or no parameter</source>
            <translation>não é uma ferramenta: não tem forma ou não tem parâmetro</translation>
        </message>
        <message>
            <source>not a tool bit: its {key} is no object</source>
            <translation>não é um arquivo de ferramenta: o {key} dele não é um objeto</translation>
        </message>
        <message>
            <source>not a tool library: it has no list of tools</source>
            <translation>não é uma biblioteca de ferramentas: não tem lista de ferramentas</translation>
        </message>
        <message>
            <source>not a tool of a table: '{line}'</source>
            <translation>não é uma ferramenta de uma tabela: '{line}'</translation>
        </message>
        <message>
            <source>not all of a parallel of the wall is seen from the middle of the room</source>
            <translation>nem toda paralela da parede é vista do meio do espaço</translation>
        </message>
        <message>
            <source>not all of the wall is seen from the middle of the room</source>
            <translation>nem toda a parede é vista do meio do espaço</translation>
        </message>
        <message>
            <source>not an STL file, or one that ends too early: it names {claimed} triangles</source>
            <translation>não é um arquivo STL, ou termina cedo demais: declara {claimed} triângulos</translation>
        </message>
        <message>
            <source>not an SVG file: {why}</source>
            <translation>não é um arquivo SVG: {why}</translation>
        </message>
        <message>
            <source>not an error: its words are none</source>
            <translation>não é um erro: suas palavras não são texto</translation>
        </message>
        <message>
            <source>not an error: {error}</source>
            <translation>não é um erro: {error}</translation>
        </message>
        <message>
            <source>not an object of JSON</source>
            <translation>não é um objeto JSON</translation>
        </message>
        <message>
            <source>not an outcome: it has no end state</source>
            <translation>não é um resultado: não diz como terminou</translation>
        </message>
        <message>
            <source>not an outcome: {fault}</source>
            <translation>não é um resultado: {fault}</translation>
        </message>
        <message>
            <source>not certain</source>
            <translation>incerto</translation>
        </message>
        <message>
            <source>not known on {platform}</source>
            <translation>não se sabe em {platform}</translation>
        </message>
        <message>
            <source>not sent</source>
            <translation>não enviado</translation>
        </message>
        <message>
            <source>not the numbers of a curve: {error}</source>
            <translation>não são os números de uma curva: {error}</translation>
        </message>
        <message>
            <source>notes must be a list</source>
            <translation>notes deve ser uma lista</translation>
        </message>
        <message>
            <source>nothing answers</source>
            <translation>nada responde</translation>
        </message>
        <message>
            <source>nothing answers at {name}: {error}</source>
            <translation>nada responde em {name}: {error}</translation>
        </message>
        <message>
            <source>nothing answers at {name}: {text}</source>
            <translation>nada responde em {name}: {text}</translation>
        </message>
        <message>
            <source>nothing has been cut yet, so there is no way back</source>
            <translation>nada foi cortado ainda, portanto não há caminho de volta</translation>
        </message>
        <message>
            <source>nothing here waits for more than a day</source>
            <translation>nada aqui espera mais que um dia</translation>
        </message>
        <message>
            <source>nothing is certainly cut</source>
            <translation>nada está certamente cortado</translation>
        </message>
        <message>
            <source>nothing is cut before this place</source>
            <translation>nada é cortado antes deste ponto</translation>
        </message>
        <message>
            <source>nothing is held any more</source>
            <translation>nada mais está retido</translation>
        </message>
        <message>
            <source>nothing is known that could be asked so</source>
            <translation>não se conhece nada que se possa perguntar assim</translation>
        </message>
        <message>
            <source>nothing is left to cut from this place on</source>
            <translation>não resta nada a cortar a partir deste ponto</translation>
        </message>
        <message>
            <source>nothing may be probed</source>
            <translation>nada pode ser apalpado</translation>
        </message>
        <message>
            <source>nothing may follow {keyword}</source>
            <translation>nada pode vir depois de {keyword}</translation>
        </message>
        <message>
            <source>nothing more is sent to the lathe: {0}</source>
            <translation>nada mais é enviado ao torno: {0}</translation>
        </message>
        <message>
            <source>nothing moves</source>
            <translation>nada se move</translation>
        </message>
        <message>
            <source>nothing moves at line {number} or after it</source>
            <translation>nada se move na linha {number} nem depois dela</translation>
        </message>
        <message>
            <source>nothing moves in the plane {plane}</source>
            <translation>nada se move no plano {plane}</translation>
        </message>
        <message>
            <source>nothing moves that could be held</source>
            <translation>nada se move que possa ser pausado</translation>
        </message>
        <message>
            <source>nothing that a tool could follow</source>
            <translation>nada que uma ferramenta possa seguir</translation>
        </message>
        <message>
            <source>nothing that an axis moves weighs more than 100 t</source>
            <translation>nada que um eixo move pesa mais que 100 t</translation>
        </message>
        <message>
            <source>numbers 1 to {largest}</source>
            <translation>números de 1 a {largest}</translation>
        </message>
        <message>
            <source>numbers behind {0}</source>
            <translation>números depois de {0}</translation>
        </message>
        <message>
            <source>o&lt;name&gt; sub ends with o&lt;name&gt; endsub</source>
            <translation>o&lt;nome&gt; sub termina com o&lt;nome&gt; endsub</translation>
        </message>
        <message>
            <source>o&lt;name&gt; sub is called by o&lt;name&gt; call</source>
            <translation>o&lt;nome&gt; sub é chamada por o&lt;nome&gt; call</translation>
        </message>
        <message>
            <source>objects or lists are nested too deeply</source>
            <translation>objetos ou listas estão aninhados fundo demais</translation>
        </message>
        <message>
            <source>on its line a contour has no scrap side for leads</source>
            <translation>sobre a linha, um contorno não tem lado de sobra para entradas e saídas</translation>
        </message>
        <message>
            <source>on its line a contour has no wall for dog-bones, a finishing pass or stock to leave</source>
            <translation>sobre a linha, um contorno não tem parede para alívio de cantos, passe de acabamento ou sobremetal</translation>
        </message>
        <message>
            <source>on the path</source>
            <translation>no caminho</translation>
        </message>
        <message>
            <source>one circle of the shape lies within another</source>
            <translation>um círculo da forma está dentro de outro</translation>
        </message>
        <message>
            <source>one more client beside {known_limit}</source>
            <translation>mais um cliente além de {known_limit}</translation>
        </message>
        <message>
            <source>one of 8, 11, 14, 17, 23, 34, but it</source>
            <translation>um de 8, 11, 14, 17, 23, 34, mas</translation>
        </message>
        <message>
            <source>one of its points is no number in bounds</source>
            <translation>um de seus pontos não é um número dentro dos limites</translation>
        </message>
        <message>
            <source>one pass is {deepest_mm:g} mm deep, deeper than the tool's diameter of {diameter_mm:g} mm; give stepdown_mm</source>
            <translation>um passe tem {deepest_mm:g} mm de profundidade, mais que o diâmetro de {diameter_mm:g} mm da ferramenta; informe stepdown_mm</translation>
        </message>
        <message>
            <source>only X, Y and Z are edited, not {letter}</source>
            <translation>só X, Y e Z são editados, e não {letter}</translation>
        </message>
        <message>
            <source>only a drag knife has a blade offset</source>
            <translation>só uma faca de arrasto tem deslocamento da lâmina</translation>
        </message>
        <message>
            <source>only a pin with a number has a port: the device file of its parallel port</source>
            <translation>só um pino com número tem uma porta: o arquivo de dispositivo da sua porta paralela</translation>
        </message>
        <message>
            <source>only arcs of G17 can be turned about Z</source>
            <translation>só arcos de G17 podem ser girados em torno de Z</translation>
        </message>
        <message>
            <source>only the controller knows where a probe stops</source>
            <translation>onde um apalpador para, só o controlador sabe</translation>
        </message>
        <message>
            <source>only the first control point goes without X and Y</source>
            <translation>só o primeiro ponto de controle dispensa X e Y</translation>
        </message>
        <message>
            <source>only {free} kB are free</source>
            <translation>só há {free} kB livres</translation>
        </message>
        <message>
            <source>only {written} of {data} bytes were accepted</source>
            <translation>só {written} de {data} bytes foram aceitos</translation>
        </message>
        <message>
            <source>open chains</source>
            <translation>cadeias abertas</translation>
        </message>
        <message>
            <source>open line {line} cuts into a part at X{x:.3f} Y{y:.3f}</source>
            <translation>a linha aberta {line} corta uma peça em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>operation '{cycle}' uses tool {tool}, which the job does not have</source>
            <translation>a operação '{cycle}' usa a ferramenta {tool}, que o trabalho não tem</translation>
        </message>
        <message>
            <source>operation must be a list of tables</source>
            <translation>operation deve ser uma lista de tabelas</translation>
        </message>
        <message>
            <source>operation {number} ({cycle}) will take long: about {length_mm:.0f} m of cut in {levels} levels</source>
            <translation>a operação {number} ({cycle}) vai demorar: cerca de {length_mm:.0f} m de corte em {levels} níveis</translation>
        </message>
        <message>
            <source>operation {number} has another {key} than its file</source>
            <translation>a operação {number} tem outro {key} do que no arquivo</translation>
        </message>
        <message>
            <source>operation {number} turns the profile '{profile}', which the job does not have: it has {names}</source>
            <translation>a operação {number} torneia o perfil '{profile}', que o trabalho não tem: ele tem {names}</translation>
        </message>
        <message>
            <source>operation {number} uses tool {tool}, which the job does not have: it has {tools}</source>
            <translation>a operação {number} usa a ferramenta {tool}, que o trabalho não tem: ele tem {tools}</translation>
        </message>
        <message>
            <source>order table</source>
            <translation>tabela de pedido</translation>
        </message>
        <message>
            <source>order text</source>
            <translation>texto de pedido</translation>
        </message>
        <message>
            <source>otherwise the move would be bent</source>
            <translation>o trajeto seria curvado de outro modo</translation>
        </message>
        <message>
            <source>outlines and islands lie too close to each other to be told apart</source>
            <translation>contornos e ilhas estão perto demais um do outro para serem distinguidos</translation>
        </message>
        <message>
            <source>overrides may not be switched</source>
            <translation>os ajustes de avanço e rotação não podem ser ligados nem desligados</translation>
        </message>
        <message>
            <source>o{name} has no end: the text is over, and it is still being skipped</source>
            <translation>o{name} não tem fim: o texto acabou e ainda está sendo pulado</translation>
        </message>
        <message>
            <source>parameter 5220 names no work system</source>
            <translation>o parâmetro 5220 não indica nenhum sistema de coordenadas</translation>
        </message>
        <message>
            <source>parameters (#) are not part of this dialect</source>
            <translation>parâmetros (#) não fazem parte deste dialeto</translation>
        </message>
        <message>
            <source>parentheses are no comment here</source>
            <translation>aqui parênteses não são comentário</translation>
        </message>
        <message>
            <source>part '{name}': {what}</source>
            <translation>peça '{name}': {what}</translation>
        </message>
        <message>
            <source>part of the drawn shape is beside the stock</source>
            <translation>parte da forma desenhada fica fora do bloco</translation>
        </message>
        <message>
            <source>part {number} goes beyond the sheet at X{x:.3f} Y{y:.3f}</source>
            <translation>a peça {number} passa da chapa em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>parting blade {0} mm</source>
            <translation>bedame de {0} mm</translation>
        </message>
        <message>
            <source>parting off takes a blade for the outside</source>
            <translation>o sangramento usa um bedame externo</translation>
        </message>
        <message>
            <source>peck_mm must not exceed depth_mm, {limit:g} mm; write 0 to drill in one go</source>
            <translation>peck_mm não deve exceder depth_mm, {limit:g} mm; escreva 0 para furar de uma vez</translation>
        </message>
        <message>
            <source>peck_mm {peck_mm:g} mm</source>
            <translation>peck_mm {peck_mm:g} mm</translation>
        </message>
        <message>
            <source>pick it again</source>
            <translation>escolha-o de novo</translation>
        </message>
        <message>
            <source>pierce farther away from earlier cuts</source>
            <translation>perfure mais longe dos cortes anteriores</translation>
        </message>
        <message>
            <source>pierce in scrap, and lead in to the contour</source>
            <translation>perfure no retalho e entre até o contorno</translation>
        </message>
        <message>
            <source>pin '{pin}' is no pin of a controller; there are {controller_pins}</source>
            <translation>o pino '{pin}' não é de um controlador; existem {controller_pins}</translation>
        </message>
        <message>
            <source>pin {pin} is no input of a parallel port; inputs are 10, 11, 12, 13 and 15</source>
            <translation>o pino {pin} não é entrada de uma porta paralela; as entradas são 10, 11, 12, 13 e 15</translation>
        </message>
        <message>
            <source>pin {pin} of {port}</source>
            <translation>pino {pin} de {port}</translation>
        </message>
        <message>
            <source>pins.{name} is no signal; there are {known}</source>
            <translation>pins.{name} não é um sinal; existem {known}</translation>
        </message>
        <message>
            <source>pins.{name}: pin {pin} is an input of the parallel port</source>
            <translation>pins.{name}: o pino {pin} é uma entrada da porta paralela</translation>
        </message>
        <message>
            <source>pins.{name}: pin {pin} is no output; outputs are 1 to 9, 14, 16 and 17</source>
            <translation>pins.{name}: o pino {pin} não é uma saída; as saídas são 1 a 9, 14, 16 e 17</translation>
        </message>
        <message>
            <source>pins: two signals are on one pin</source>
            <translation>pins: dois sinais estão no mesmo pino</translation>
        </message>
        <message>
            <source>pitch_mm is lowered to {pitch_mm:.3f} mm, for the helix must not fall by more than {most_deg:g}°</source>
            <translation>pitch_mm é reduzido para {pitch_mm:.3f} mm, pois a hélice não pode descer mais que {most_deg:g}°</translation>
        </message>
        <message>
            <source>place not known</source>
            <translation>local desconhecido</translation>
        </message>
        <message>
            <source>place them farther apart, or --allow-overlap</source>
            <translation>afaste-os mais ou use --allow-overlap</translation>
        </message>
        <message>
            <source>places of the machine became those of the work, right for this work zero only</source>
            <translation>lugares da máquina viraram lugares da peça, certos só para este zero-peça</translation>
        </message>
        <message>
            <source>places where a chain crosses itself</source>
            <translation>lugares onde uma cadeia cruza a si mesma</translation>
        </message>
        <message>
            <source>places where closed chains cross each other</source>
            <translation>lugares onde cadeias fechadas se cruzam</translation>
        </message>
        <message>
            <source>planes are an option of the build: leave it out, arcs are in XY</source>
            <translation>os planos são uma opção da compilação: omita-a, os arcos ficam em XY</translation>
        </message>
        <message>
            <source>please report it, with the drawing</source>
            <translation>por favor relate isso, com o desenho</translation>
        </message>
        <message>
            <source>please report it, with the program</source>
            <translation>relate-o, por favor, com o programa</translation>
        </message>
        <message>
            <source>plug the controller in, or give one of the ports that are there: {names}</source>
            <translation>conecte o controlador, ou indique uma das portas que há: {names}</translation>
        </message>
        <message>
            <source>points are not pairs of x and y</source>
            <translation>os pontos não são pares de x e y</translation>
        </message>
        <message>
            <source>points with its blocks taken apart ({splines})</source>
            <translation>pontos com os seus blocos desmembrados ({splines})</translation>
        </message>
        <message>
            <source>positions are not compared with the path any more: {why}</source>
            <translation>as posições não são mais comparadas com o percurso: {why}</translation>
        </message>
        <message>
            <source>prepare the program again</source>
            <translation>prepare o programa de novo</translation>
        </message>
        <message>
            <source>prepare this program's own</source>
            <translation>prepare as linhas deste próprio programa</translation>
        </message>
        <message>
            <source>press the machine's own switch, or let it run to its end</source>
            <translation>use a chave da própria máquina, ou deixe-a ir até o fim</translation>
        </message>
        <message>
            <source>press the machine's switch; no further line is sent</source>
            <translation>use a chave da máquina; nenhuma outra linha é enviada</translation>
        </message>
        <message>
            <source>process must be a text</source>
            <translation>process deve ser um texto</translation>
        </message>
        <message>
            <source>profiles are turned towards the chuck with a right-hand insert</source>
            <translation>perfis são torneados em direção à placa com uma pastilha direita</translation>
        </message>
        <message>
            <source>programs are not written in the dialect {dialect}</source>
            <translation>não se escrevem programas no dialeto {dialect}</translation>
        </message>
        <message>
            <source>programs are read for machines with three axes, or with nine</source>
            <translation>programas são lidos para máquinas com três eixos ou com nove</translation>
        </message>
        <message>
            <source>programs of these names are there already</source>
            <translation>já existem programas com esses nomes</translation>
        </message>
        <message>
            <source>programs of {language} are in one unit only</source>
            <translation>programas de {language} usam uma só unidade</translation>
        </message>
        <message>
            <source>programs with more than the axes X, Y and Z are not written</source>
            <translation>não se escrevem programas com outros eixos além de X, Y e Z</translation>
        </message>
        <message>
            <source>prove parts of the program alone</source>
            <translation>verifique partes do programa em separado</translation>
        </message>
        <message>
            <source>prove them together: cncstepper run JOB</source>
            <translation>verifique-os juntos: cncstepper run JOB</translation>
        </message>
        <message>
            <source>pulses are forgotten at rest only, not in state {state}</source>
            <translation>pulsos só são descartados em repouso, não no estado {state}</translation>
        </message>
        <message>
            <source>pulses are those of a machine</source>
            <translation>os pulsos são os de uma máquina</translation>
        </message>
        <message>
            <source>pulses can be retracted only in a hold, not in state {state}</source>
            <translation>só se volta pelos pulsos em pausa, não no estado {state}</translation>
        </message>
        <message>
            <source>pulses, relays and trials of a rate: `cncstepper machine-test` does them</source>
            <translation>pulsos, relés e ensaios de uma taxa: `cncstepper machine-test` os faz</translation>
        </message>
        <message>
            <source>put a text with commas in quotes</source>
            <translation>ponha entre aspas um texto com vírgulas</translation>
        </message>
        <message>
            <source>put in tool {tool:g}</source>
            <translation>coloque a ferramenta {tool:g}</translation>
        </message>
        <message>
            <source>put it before the way</source>
            <translation>ponha-a antes do trecho</translation>
        </message>
        <message>
            <source>put it in brackets</source>
            <translation>ponha-a entre colchetes</translation>
        </message>
        <message>
            <source>put some in named parameters</source>
            <translation>ponha alguns em parâmetros com nome</translation>
        </message>
        <message>
            <source>put the card in, then mount it with $FM</source>
            <translation>coloque o cartão e monte-o com $FM</translation>
        </message>
        <message>
            <source>radii and resolution must be positive</source>
            <translation>os semieixos e a resolução devem ser positivos</translation>
        </message>
        <message>
            <source>radius 0 mm</source>
            <translation>raio 0 mm</translation>
        </message>
        <message>
            <source>radius {0} mm at z {1} mm</source>
            <translation>raio {0} mm em z {1} mm</translation>
        </message>
        <message>
            <source>raise F, or turn the spindle slower</source>
            <translation>aumente F, ou diminua a rotação do spindle</translation>
        </message>
        <message>
            <source>raise first_depth_mm</source>
            <translation>aumente first_depth_mm</translation>
        </message>
        <message>
            <source>raise interval_ms of the profile's signals</source>
            <translation>aumente interval_ms dos sinais do perfil</translation>
        </message>
        <message>
            <source>raise pulloff_mm in its configuration, or check the switch</source>
            <translation>aumente pulloff_mm na configuração, ou verifique o fim de curso</translation>
        </message>
        <message>
            <source>raise the R word of the drilling cycle</source>
            <translation>aumente a palavra R do ciclo de furação</translation>
        </message>
        <message>
            <source>raise the feed</source>
            <translation>aumente o avanço</translation>
        </message>
        <message>
            <source>raise the feed, or turn the spindle slower</source>
            <translation>aumente o avanço ou gire o spindle mais devagar</translation>
        </message>
        <message>
            <source>raise the pull-off $27 or check the switch</source>
            <translation>aumente o recuo $27 ou verifique o fim de curso</translation>
        </message>
        <message>
            <source>raise the tool first, or switch it off</source>
            <translation>levante antes a ferramenta, ou desligue-a</translation>
        </message>
        <message>
            <source>ramp = "table" and planner.waits belong together</source>
            <translation>ramp = "table" e planner.waits andam juntos</translation>
        </message>
        <message>
            <source>ramp {ramp_deg:g} deg</source>
            <translation>rampa {ramp_deg:g} deg</translation>
        </message>
        <message>
            <source>rapids and cuts would be exchanged</source>
            <translation>rápidos e cortes seriam trocados entre si</translation>
        </message>
        <message>
            <source>rapids move at the feed in force: no F for them was given</source>
            <translation>os rápidos usam o avanço em vigor: nenhum F foi dado para eles</translation>
        </message>
        <message>
            <source>read as a flat mill: '{name}' does not name a shape</source>
            <translation>tida como fresa de topo: '{name}' não nomeia uma forma que as palavras de uma tabela digam</translation>
        </message>
        <message>
            <source>read its message, and correct that line</source>
            <translation>veja o que ele diz e corrija essa linha</translation>
        </message>
        <message>
            <source>read its message, close other programs, or choose lower speeds</source>
            <translation>veja o que ele diz, encerre outros programas, ou escolha velocidades menores</translation>
        </message>
        <message>
            <source>read its output, and report it</source>
            <translation>veja o que ele imprimiu e relate</translation>
        </message>
        <message>
            <source>read the controller's start-up messages ($SS) and correct its configuration</source>
            <translation>leia as mensagens de partida do controlador ($SS) e corrija a configuração</translation>
        </message>
        <message>
            <source>read the message that the macro gives</source>
            <translation>leia a mensagem que a macro dá</translation>
        </message>
        <message>
            <source>read the program as a whole</source>
            <translation>leia o programa inteiro</translation>
        </message>
        <message>
            <source>reading '{suffix}' files needs {programs}, which is not installed</source>
            <translation>para ler arquivos '{suffix}' é preciso {programs}, que não está aqui</translation>
        </message>
        <message>
            <source>reading the solid takes too long</source>
            <translation>a leitura do sólido demora demais</translation>
        </message>
        <message>
            <source>reading the solid takes too much memory</source>
            <translation>a leitura do sólido ocupa memória demais</translation>
        </message>
        <message>
            <source>reading was cancelled</source>
            <translation>a leitura foi cancelada</translation>
        </message>
        <message>
            <source>real time</source>
            <translation>tempo real</translation>
        </message>
        <message>
            <source>redraw it</source>
            <translation>redesenhe-o</translation>
        </message>
        <message>
            <source>relay: {twice} is there twice</source>
            <translation>relay: {twice} aparece duas vezes</translation>
        </message>
        <message>
            <source>release buttons, door and emergency stop, then restart the controller</source>
            <translation>solte botões, porta e parada de emergência e reinicie o controlador</translation>
        </message>
        <message>
            <source>release buttons, door, switches and emergency stop, then home the machine</source>
            <translation>solte botões, porta, fins de curso e parada de emergência e referencie a máquina</translation>
        </message>
        <message>
            <source>release it, reset the controller, then home the machine</source>
            <translation>solte-a, reinicie o controlador e referencie a máquina</translation>
        </message>
        <message>
            <source>release the emergency stop, then reset the controller</source>
            <translation>solte a parada de emergência e reinicie o controlador</translation>
        </message>
        <message>
            <source>release_line goes with line</source>
            <translation>release_line acompanha line</translation>
        </message>
        <message>
            <source>reload it</source>
            <translation>recarregue-o</translation>
        </message>
        <message>
            <source>remove it as {user}; until then the position is unknown again at each connection</source>
            <translation>remova-o como {user}; até lá, a posição volta a ser desconhecida a cada conexão</translation>
        </message>
        <message>
            <source>remove it; only plain ASCII without ? ! ~ may be sent</source>
            <translation>remova-o; só ASCII puro sem ? ! ~ pode ser enviado</translation>
        </message>
        <message>
            <source>remove the lines with `%`</source>
            <translation>retire as linhas com `%`</translation>
        </message>
        <message>
            <source>rename one of them</source>
            <translation>renomeie uma delas</translation>
        </message>
        <message>
            <source>renumber by hand</source>
            <translation>renumere à mão</translation>
        </message>
        <message>
            <source>repair the mesh, and export it again</source>
            <translation>repare a malha e exporte-a de novo</translation>
        </message>
        <message>
            <source>repair the solid, or use another thickness</source>
            <translation>repare o sólido ou use outra espessura</translation>
        </message>
        <message>
            <source>reset it, then home it or set its zero again</source>
            <translation>reinicie-o; depois referencie a máquina ou defina o zero de novo</translation>
        </message>
        <message>
            <source>resolution_mm is too coarse for the tool</source>
            <translation>resolution_mm é grossa demais para a ferramenta</translation>
        </message>
        <message>
            <source>restart at another place, or send the whole program</source>
            <translation>retome em outro ponto, ou envie o programa inteiro</translation>
        </message>
        <message>
            <source>restart at the begin of its operation, or send the whole program</source>
            <translation>retome no início da operação, ou envie o programa inteiro</translation>
        </message>
        <message>
            <source>restart earlier, or make a new part</source>
            <translation>retome mais cedo, ou faça uma nova peça</translation>
        </message>
        <message>
            <source>restart of {name} at line {file_line}</source>
            <translation>retomada de {name} na linha {file_line}</translation>
        </message>
        <message>
            <source>restart the controller</source>
            <translation>reinicie o controlador</translation>
        </message>
        <message>
            <source>restart the program at a line before it</source>
            <translation>recomece o programa em uma linha anterior</translation>
        </message>
        <message>
            <source>restarts are written for grbl, grblHAL, FluidNC, LinuxCNC and Mach: convert it, or run it whole</source>
            <translation>retomadas são escritas para grbl, grblHAL, FluidNC, LinuxCNC e Mach: converta-o, ou execute-o inteiro</translation>
        </message>
        <message>
            <source>resume again, or set the zero so that the move to it is within the travel</source>
            <translation>retome de novo, ou defina o zero de modo que o caminho fique dentro do curso</translation>
        </message>
        <message>
            <source>resume again; if $341 is not 0, finish the controller's own tool change first</source>
            <translation>continue de novo; onde $341 não é 0, faça antes o que o próprio controlador pede na troca de ferramenta</translation>
        </message>
        <message>
            <source>resume or stop it where it was started, or with: cncstepper back --session {file}</source>
            <translation>continue-o ou pare-o onde foi iniciado, ou com: cncstepper back --session {file}</translation>
        </message>
        <message>
            <source>resume what it was doing, or reset it</source>
            <translation>retome o que fazia, ou reinicie-a</translation>
        </message>
        <message>
            <source>resume when it is at standstill</source>
            <translation>continue quando ela estiver parada</translation>
        </message>
        <message>
            <source>resume, and hold at a later move</source>
            <translation>retome, e retenha num movimento posterior</translation>
        </message>
        <message>
            <source>resume, and hold once the machine moves</source>
            <translation>retome, e retenha quando a máquina se mover</translation>
        </message>
        <message>
            <source>resume, so that the change is over, and hold it again then</source>
            <translation>continue, para que a troca termine, e então segure de novo</translation>
        </message>
        <message>
            <source>retract along X beside the tailstock, or move it away</source>
            <translation>recue em X ao lado do cabeçote móvel, ou afaste-o</translation>
        </message>
        <message>
            <source>retract before it, or make it a feed</source>
            <translation>recue antes, ou faça dele um avanço</translation>
        </message>
        <message>
            <source>retract mode set to old_z</source>
            <translation>modo de recuo: Z anterior</translation>
        </message>
        <message>
            <source>retract mode set to r_plane</source>
            <translation>modo de recuo: plano R</translation>
        </message>
        <message>
            <source>retracted along the cut: go further back, forward, or resume from here</source>
            <translation>de volta ao longo do corte: continue para trás, para a frente, ou retome daqui</translation>
        </message>
        <message>
            <source>route it around the part, through scrap</source>
            <translation>passe o fio em volta da peça, pelo que vira retalho</translation>
        </message>
        <message>
            <source>rows must be a list of tables</source>
            <translation>as linhas têm de ser uma lista de tabelas</translation>
        </message>
        <message>
            <source>run 'make setup' beside the workbench, or let Tools &gt; Addon Manager install them, or install them for Python {version_info}.{version_info2} into a folder of their own (pip install --target FOLDER) and name it in the environment variable CNCSTEPPER_PACKAGES</source>
            <translation>rode 'make setup' na pasta da bancada, ou instale-os por Ferramentas &gt; Gerenciador de extensões, ou instale-os para Python {version_info}.{version_info2} em uma pasta própria (pip install --target PASTA) e indique-a na variável de ambiente CNCSTEPPER_PACKAGES</translation>
        </message>
        <message>
            <source>run this job with cncstepper run</source>
            <translation>execute este trabalho com cncstepper run</translation>
        </message>
        <message>
            <source>rx ry</source>
            <translation>rx ry</translation>
        </message>
        <message>
            <source>save it again</source>
            <translation>salve-o de novo</translation>
        </message>
        <message>
            <source>save it again as PNG</source>
            <translation>salve-a de novo como PNG</translation>
        </message>
        <message>
            <source>save it again from the drawing program as plain SVG</source>
            <translation>salve-o de novo no programa de desenho como SVG simples</translation>
        </message>
        <message>
            <source>save it as CSV</source>
            <translation>salve como CSV</translation>
        </message>
        <message>
            <source>save it as CSV in UTF-8</source>
            <translation>salve como CSV em UTF-8</translation>
        </message>
        <message>
            <source>save it as DXF again, as R2000 or newer</source>
            <translation>salve-o de novo como DXF, R2000 ou mais recente</translation>
        </message>
        <message>
            <source>save it as UTF-8</source>
            <translation>salve-o como UTF-8</translation>
        </message>
        <message>
            <source>save it as a file</source>
            <translation>salve-o como arquivo</translation>
        </message>
        <message>
            <source>save it as one of {known}</source>
            <translation>salve-o como um de {known}</translation>
        </message>
        <message>
            <source>save it with styles as attributes</source>
            <translation>salve-o com os estilos como atributos</translation>
        </message>
        <message>
            <source>save the file as UTF-8 text</source>
            <translation>salve o arquivo como texto UTF-8</translation>
        </message>
        <message>
            <source>scale all axes alike</source>
            <translation>use a mesma escala em todos os eixos</translation>
        </message>
        <message>
            <source>scale all axes alike, or write feeds a minute (G94)</source>
            <translation>use a mesma escala em todos os eixos ou escreva avanços por minuto (G94)</translation>
        </message>
        <message>
            <source>scale it down: 10 pixels a mm are enough for any cutter</source>
            <translation>reduza-a: 10 pixels por mm bastam para qualquer ferramenta</translation>
        </message>
        <message>
            <source>scripts that are written from the right are not set</source>
            <translation>escritas da direita para a esquerda não são compostas</translation>
        </message>
        <message>
            <source>see its log, and the machine</source>
            <translation>veja seu registro, e a máquina</translation>
        </message>
        <message>
            <source>see its log, report it</source>
            <translation>veja o registro e relate-o</translation>
        </message>
        <message>
            <source>see that it is a folder, that it is yours, and that you may write there</source>
            <translation>verifique que é uma pasta, que é sua e que você pode escrever nela</translation>
        </message>
        <message>
            <source>see that the dial counts in the axis' sense, and measure again</source>
            <translation>veja se o relógio conta no sentido do eixo e meça de novo</translation>
        </message>
        <message>
            <source>see whether it is whole</source>
            <translation>veja se está completo</translation>
        </message>
        <message>
            <source>select a sketch, wires, faces or edges</source>
            <translation>selecione um esboço, arames, faces ou arestas</translation>
        </message>
        <message>
            <source>select the plane with G17, G18, G19</source>
            <translation>selecione o plano com G17, G18 ou G19</translation>
        </message>
        <message>
            <source>select those of its faces or edges that count</source>
            <translation>selecione as faces ou arestas dele que contam</translation>
        </message>
        <message>
            <source>send another one</source>
            <translation>envie outro</translation>
        </message>
        <message>
            <source>send it again</source>
            <translation>envie de novo</translation>
        </message>
        <message>
            <source>send the file again</source>
            <translation>envie o arquivo de novo</translation>
        </message>
        <message>
            <source>send the program without O-words</source>
            <translation>envie o programa sem palavras O</translation>
        </message>
        <message>
            <source>send the wanted words by hand or reset the controller, look at the work zero, and send again</source>
            <translation>envie à mão as palavras pedidas ou reinicie o controlador, verifique o zero-peça e envie de novo</translation>
        </message>
        <message>
            <source>send the whole program</source>
            <translation>envie o programa inteiro</translation>
        </message>
        <message>
            <source>send them to a machine whose pulses this computer makes</source>
            <translation>envie-as a uma máquina cujos pulsos este computador gera</translation>
        </message>
        <message>
            <source>set $0 to 2 or more</source>
            <translation>ponha $0 em 2 ou mais</translation>
        </message>
        <message>
            <source>set $0 to 3 or more</source>
            <translation>ponha $0 em 3 ou mais</translation>
        </message>
        <message>
            <source>set $22=1 if the machine has limit switches</source>
            <translation>use $22=1 se a máquina tem fins de curso</translation>
        </message>
        <message>
            <source>set $32=0 or use a build with PWM</source>
            <translation>use $32=0 ou um firmware com PWM</translation>
        </message>
        <message>
            <source>set F by the chart</source>
            <translation>ajuste F pela tabela</translation>
        </message>
        <message>
            <source>set Z by the chart</source>
            <translation>ajuste Z pela tabela</translation>
        </message>
        <message>
            <source>set a lead_in, or pierce_mm to half of the kerf, {half_mm:g}</source>
            <translation>defina um lead_in, ou pierce_mm como metade da largura de corte, {half_mm:g}</translation>
        </message>
        <message>
            <source>set again at the pause at line {line}: {places} (machine, mm); later lines use this zero, earlier ones the old one</source>
            <translation>definido de novo na pausa da linha {line}: {places} (máquina, mm); o que vem depois conta a partir daí, o que veio antes, a partir do antigo</translation>
        </message>
        <message>
            <source>set backlash_mm to 0 in the machine profile</source>
            <translation>ponha backlash_mm em 0 no perfil da máquina</translation>
        </message>
        <message>
            <source>set corner_dwell_s to at most {stand_s:g}, or cut more slowly</source>
            <translation>ponha corner_dwell_s em no máximo {stand_s:g}, ou corte mais devagar</translation>
        </message>
        <message>
            <source>set entry_slit = true, which cuts a slit through the part into each hole, or leave the holes out</source>
            <translation>defina entry_slit = true, que corta uma fenda pela peça até cada furo, ou deixe os furos de fora</translation>
        </message>
        <message>
            <source>set it again, and do not start before it is right</source>
            <translation>defina-o de novo, e não inicie antes que esteja certo</translation>
        </message>
        <message>
            <source>set it with M61 Q and the tool's number</source>
            <translation>informe-a com M61 Q e o número da ferramenta</translation>
        </message>
        <message>
            <source>set its zero again</source>
            <translation>defina o zero dela de novo</translation>
        </message>
        <message>
            <source>set margin_mm to at most {margin_mm:.3g}, or move the parts apart</source>
            <translation>defina margin_mm como no máximo {margin_mm:.3g}, ou afaste as peças</translation>
        </message>
        <message>
            <source>set pierce_mm to that limit, or leave {scrap}</source>
            <translation>ponha pierce_mm nesse limite, ou deixe {scrap}</translation>
        </message>
        <message>
            <source>set process to "plasma", "oxyfuel", "laser", "waterjet", "drag-knife" or "scribe"</source>
            <translation>defina process como "plasma", "oxyfuel", "laser", "waterjet", "drag-knife" ou "scribe"</translation>
        </message>
        <message>
            <source>set ramp_deg and no tabs, or use a mill that cuts over its centre</source>
            <translation>ponha ramp_deg e nenhuma ponte, ou use uma fresa que corte sobre o centro</translation>
        </message>
        <message>
            <source>set the machine's settings again</source>
            <translation>refaça as configurações da máquina</translation>
        </message>
        <message>
            <source>set the machine's settings again, then home it</source>
            <translation>configure a máquina de novo e referencie-a</translation>
        </message>
        <message>
            <source>set the zero again</source>
            <translation>defina o zero de novo</translation>
        </message>
        <message>
            <source>set the zero by hand</source>
            <translation>defina o zero à mão</translation>
        </message>
        <message>
            <source>set the zero on the stock, then confirm it (--zero-confirmed)</source>
            <translation>defina o zero no bloco e confirme-o (--zero-confirmed)</translation>
        </message>
        <message>
            <source>set the zero there, or check the program again with the zero that is set (--work-zero)</source>
            <translation>defina o zero ali, ou verifique o programa de novo com o zero que está definido (--work-zero)</translation>
        </message>
        <message>
            <source>set the zero with G10 L2 instead</source>
            <translation>defina o zero com G10 L2</translation>
        </message>
        <message>
            <source>set them by hand, then try again</source>
            <translation>ajuste-as à mão e tente de novo</translation>
        </message>
        <message>
            <source>set them farther apart</source>
            <translation>afaste-os</translation>
        </message>
        <message>
            <source>set up a program of that name on the machine</source>
            <translation>instale na máquina um programa com esse nome</translation>
        </message>
        <message>
            <source>set width_mm to at most {width_mm:.2f}</source>
            <translation>ponha width_mm em no máximo {width_mm:.2f}</translation>
        </message>
        <message>
            <source>set {cadquery} to a Python that has CadQuery, or {freecad} to FreeCAD's command</source>
            <translation>aponte {cadquery} para um Python que tenha o CadQuery, ou {freecad} para o comando do FreeCAD</translation>
        </message>
        <message>
            <source>sets G92 as it was: {array}</source>
            <translation>define G92 como estava: {array}</translation>
        </message>
        <message>
            <source>several turns of an arc became one arc a turn</source>
            <translation>várias voltas de um arco viraram um arco por volta</translation>
        </message>
        <message>
            <source>shape '{name}' goes without the {entity_kind} {handle} of its drawing: {why}</source>
            <translation>a forma '{name}' fica sem {entity_kind} {handle} do seu desenho: {why}</translation>
        </message>
        <message>
            <source>shape '{name}' goes without {skipped} more things of its drawing</source>
            <translation>a forma '{name}' fica sem mais {skipped} coisas do seu desenho</translation>
        </message>
        <message>
            <source>shape '{name}': no shape takes the chains of its drawing at the nesting level {missed}</source>
            <translation>forma '{name}': nenhuma forma toma as cadeias do desenho no nível de aninhamento {missed}</translation>
        </message>
        <message>
            <source>shape '{name}': two ends lie {size_mm:.3g} mm apart at X{x:.3f} Y{y:.3f}</source>
            <translation>forma '{name}': duas pontas ficam a {size_mm:.3g} mm uma da outra em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>sheet refused</source>
            <translation>chapa recusada</translation>
        </message>
        <message>
            <source>sheet {number}: {small} pieces below 1 mm2 left out</source>
            <translation>chapa {number}: {small} pedaços abaixo de 1 mm2 ficaram de fora</translation>
        </message>
        <message>
            <source>sheet_cut does not cut by {process}</source>
            <translation>sheet_cut não corta com {process}</translation>
        </message>
        <message>
            <source>short slice</source>
            <translation>fatia curta</translation>
        </message>
        <message>
            <source>shorten or split that line</source>
            <translation>encurte ou divida essa linha</translation>
        </message>
        <message>
            <source>shorten that line</source>
            <translation>encurte essa linha</translation>
        </message>
        <message>
            <source>shorten the start-up line</source>
            <translation>encurte a linha de partida</translation>
        </message>
        <message>
            <source>shorten the travel along Z, or let the bar stick out further</source>
            <translation>encurte o percurso em Z, ou deixe a barra mais para fora</translation>
        </message>
        <message>
            <source>simplify it, or divide it</source>
            <translation>simplifique-o, ou divida-o</translation>
        </message>
        <message>
            <source>simplify the solid, or end the script's loop</source>
            <translation>simplifique o sólido ou termine o laço do script</translation>
        </message>
        <message>
            <source>simulated on the stock that the earlier moves have left; the wanted shape is unknown and was not compared</source>
            <translation>cortado no material que os movimentos anteriores deixaram; a forma desejada não é conhecida, por isso não é julgado</translation>
        </message>
        <message>
            <source>smooth_mm belongs to points</source>
            <translation>smooth_mm pertence a points</translation>
        </message>
        <message>
            <source>soft limits need homing</source>
            <translation>limites de software exigem referenciamento</translation>
        </message>
        <message>
            <source>solids of the file overlap at sheet {number}</source>
            <translation>sólidos do arquivo se sobrepõem na chapa {number}</translation>
        </message>
        <message>
            <source>something else than grbl answers</source>
            <translation>quem responde não é um grbl</translation>
        </message>
        <message>
            <source>spacing_mm asks for more than {most_tabs} tabs on one contour</source>
            <translation>spacing_mm pede mais de {most_tabs} pontes em um contorno</translation>
        </message>
        <message>
            <source>spindle stop</source>
            <translation>parada do fuso</translation>
        </message>
        <message>
            <source>spindle, coolant or tool would be another</source>
            <translation>spindle, refrigeração ou ferramenta seriam outros</translation>
        </message>
        <message>
            <source>spindle, torch or beam is on</source>
            <translation>fuso, maçarico ou feixe está ligado</translation>
        </message>
        <message>
            <source>spindle, torch or beam may still be on: look, and switch them off at the machine</source>
            <translation>spindle, tocha ou feixe podem ainda estar ligados: verifique e desligue-os na máquina</translation>
        </message>
        <message>
            <source>spindle_rpm = {0}, for example</source>
            <translation>spindle_rpm = {0}, por exemplo</translation>
        </message>
        <message>
            <source>splines lie in the plane XY</source>
            <translation>splines ficam no plano XY</translation>
        </message>
        <message>
            <source>split it into several drawings</source>
            <translation>divida-o em vários desenhos</translation>
        </message>
        <message>
            <source>split it, or send it with cncstepper send</source>
            <translation>divida-o, ou envie-o com cncstepper send</translation>
        </message>
        <message>
            <source>split that line</source>
            <translation>divida essa linha</translation>
        </message>
        <message>
            <source>split that line in two</source>
            <translation>divida essa linha em duas</translation>
        </message>
        <message>
            <source>split the chart</source>
            <translation>divida a tabela</translation>
        </message>
        <message>
            <source>split the file</source>
            <translation>divida o arquivo</translation>
        </message>
        <message>
            <source>split the order</source>
            <translation>divida o pedido</translation>
        </message>
        <message>
            <source>split the program</source>
            <translation>divida o programa</translation>
        </message>
        <message>
            <source>spyrrow is not installed</source>
            <translation>o spyrrow não está instalado</translation>
        </message>
        <message>
            <source>square, circle and squareness need the axes X and Y</source>
            <translation>quadrado, círculo e esquadro precisam dos eixos X e Y</translation>
        </message>
        <message>
            <source>start it with cncstepper send</source>
            <translation>inicie-o com cncstepper send</translation>
        </message>
        <message>
            <source>start it, or correct the URL</source>
            <translation>inicie-o, ou corrija a URL</translation>
        </message>
        <message>
            <source>start it, or write socket://host:port</source>
            <translation>inicie-a, ou escreva socket://host:porta</translation>
        </message>
        <message>
            <source>start nearer to the part, then unlock with $X</source>
            <translation>comece mais perto da peça e destrave com $X</translation>
        </message>
        <message>
            <source>start one: dask scheduler --host 127.0.0.1, and dask worker for each core</source>
            <translation>inicie um: dask scheduler --host 127.0.0.1, e dask worker para cada núcleo</translation>
        </message>
        <message>
            <source>start scheduler and workers with TLS keys, and give tls:// with --tls-ca, --tls-cert and --tls-key</source>
            <translation>inicie escalonador e processos de trabalho com chaves TLS e informe tls:// com --tls-ca, --tls-cert e --tls-key</translation>
        </message>
        <message>
            <source>start the spindle with M3 and S before it</source>
            <translation>ligue o spindle com M3 e S antes dele</translation>
        </message>
        <message>
            <source>start the torch with M3 $0 S1, the scribe with M3 $1 S1, a spot with M3 $2 S1</source>
            <translation>ligue a tocha com M3 $0 S1, o riscador com M3 $1 S1, uma marca com M3 $2 S1</translation>
        </message>
        <message>
            <source>starts the spindle at {spindle_rpm:g} rpm, {sense}</source>
            <translation>liga o fuso a {spindle_rpm:g} rpm, {sense}</translation>
        </message>
        <message>
            <source>stepover_mm (ae)</source>
            <translation>stepover_mm (ae)</translation>
        </message>
        <message>
            <source>stepover_mm asks for more than {most_passes} passes</source>
            <translation>stepover_mm pede mais de {most_passes} passes</translation>
        </message>
        <message>
            <source>stepover_mm asks for more than {most_passes} turns</source>
            <translation>stepover_mm pede mais de {most_passes} voltas</translation>
        </message>
        <message>
            <source>stepover_mm is too small for the engagement to be bounded by it</source>
            <translation>stepover_mm é pequeno demais para limitar o engajamento</translation>
        </message>
        <message>
            <source>steps_per_mm is {steps_per_mm:g}, but the drive gives {pulses_per_mm:g}</source>
            <translation>steps_per_mm é {steps_per_mm:g}, mas o acionamento dá {pulses_per_mm:g}</translation>
        </message>
        <message>
            <source>stop it, then home it, or set the zero of all axes</source>
            <translation>pare-a e depois referencie-a ou defina o zero de todos os eixos</translation>
        </message>
        <message>
            <source>stop the job: steps may be lost, or the machine was moved by hand</source>
            <translation>pare o trabalho: passos podem ter-se perdido, ou a máquina foi movida à mão</translation>
        </message>
        <message>
            <source>stop the machine with its own buttons if it must stop now</source>
            <translation>pare a máquina com os botões dela se ela precisa parar agora</translation>
        </message>
        <message>
            <source>stop the program, then jog</source>
            <translation>pare o programa e depois mova à mão</translation>
        </message>
        <message>
            <source>stop with M5 and M0 before the new tool</source>
            <translation>pare com M5 e M0 antes da nova ferramenta</translation>
        </message>
        <message>
            <source>stopped as asked after {acknowledged} lines</source>
            <translation>parado como pedido após {acknowledged} linhas</translation>
        </message>
        <message>
            <source>stopped before the first line was sent</source>
            <translation>parado antes de enviar a primeira linha</translation>
        </message>
        <message>
            <source>stretches drawn twice</source>
            <translation>trechos desenhados duas vezes</translation>
        </message>
        <message>
            <source>stretches drawn twice were taken out</source>
            <translation>trechos desenhados duas vezes foram retirados</translation>
        </message>
        <message>
            <source>subroutines and loops were written out</source>
            <translation>sub-rotinas e laços foram escritos por extenso</translation>
        </message>
        <message>
            <source>subroutines call each other too deep</source>
            <translation>as sub-rotinas chamam umas às outras fundo demais</translation>
        </message>
        <message>
            <source>switch it off and on again; if it stays, look at its wiring</source>
            <translation>desligue e ligue de novo; se continuar, verifique a fiação</translation>
        </message>
        <message>
            <source>switch it off first: M5</source>
            <translation>desligue antes: M5</translation>
        </message>
        <message>
            <source>switch it off with M5 before it</source>
            <translation>desligue-o antes com M5</translation>
        </message>
        <message>
            <source>switch it off with M5 sooner</source>
            <translation>desligue antes com M5</translation>
        </message>
        <message>
            <source>switch it on with M3 and S before it</source>
            <translation>ligue-o antes com M3 e S</translation>
        </message>
        <message>
            <source>switch it on with M3 beside the sheet</source>
            <translation>ligue com M3 ao lado da chapa</translation>
        </message>
        <message>
            <source>switch the lathe off and on, connect again and set its zero</source>
            <translation>desligue e ligue o torno, conecte de novo e defina o zero</translation>
        </message>
        <message>
            <source>switch the lathe off and on, connect again and set its zero; unlock an alarm with $X</source>
            <translation>desligue e ligue o torno, conecte de novo e ajuste o zero; destrave um alarme com $X</translation>
        </message>
        <message>
            <source>switch the lathe off and on, set its zero by hand, and send the whole program</source>
            <translation>desligue e ligue o torno, ajuste o zero à mão e envie o programa inteiro</translation>
        </message>
        <message>
            <source>switch the lathe on in manual mode before it moves; its position is reckoned, nothing reports it</source>
            <translation>ligue o torno em modo manual antes que ele se mova; a posição é calculada, nada a informa</translation>
        </message>
        <message>
            <source>switch the machine off, or unlock and home it afterwards at the machine itself</source>
            <translation>desligue a máquina, ou depois destrave e referencie na própria máquina</translation>
        </message>
        <message>
            <source>switch the spindle on before that line</source>
            <translation>ligue o spindle antes dessa linha</translation>
        </message>
        <message>
            <source>switches the beam on at S{spindle_rpm:g} once it is down</source>
            <translation>liga o feixe em S{spindle_rpm:g} depois de descer</translation>
        </message>
        <message>
            <source>switches the coolant on</source>
            <translation>liga o fluido de corte</translation>
        </message>
        <message>
            <source>table_ms may hold no wait that is longer than the one before it</source>
            <translation>table_ms não pode ter uma espera mais longa que a anterior</translation>
        </message>
        <message>
            <source>tables or lists are nested too deeply</source>
            <translation>tabelas ou listas estão aninhadas fundo demais</translation>
        </message>
        <message>
            <source>tabs need either count or spacing_mm</source>
            <translation>pontes precisam de count ou de spacing_mm</translation>
        </message>
        <message>
            <source>take a larger stock, a smaller margin or placement = "box"</source>
            <translation>use um material maior, uma margem menor ou placement = "box"</translation>
        </message>
        <message>
            <source>take a larger tolerance</source>
            <translation>use uma tolerância maior</translation>
        </message>
        <message>
            <source>take a larger tolerance, or draw lines or arcs in their place</source>
            <translation>use uma tolerância maior ou desenhe retas ou arcos no lugar</translation>
        </message>
        <message>
            <source>take a larger tolerance_mm, or draw polylines or arcs in their place</source>
            <translation>use um tolerance_mm maior, ou desenhe polilinhas ou arcos no lugar delas</translation>
        </message>
        <message>
            <source>take a thickness within it, another consumable, or give a chart of your own with this row</source>
            <translation>use uma espessura dentro dela, outro consumível, ou dê uma tabela própria com esta linha</translation>
        </message>
        <message>
            <source>take it out</source>
            <translation>retire-o</translation>
        </message>
        <message>
            <source>take it out of the name</source>
            <translation>retire-o do nome</translation>
        </message>
        <message>
            <source>take it out of the program</source>
            <translation>retire-o do programa</translation>
        </message>
        <message>
            <source>take it out or add its code</source>
            <translation>retire-a ou acrescente o seu código</translation>
        </message>
        <message>
            <source>take it out, or use one of: NAME, {keys}</source>
            <translation>retire-a, ou use uma destas: NAME, {keys}</translation>
        </message>
        <message>
            <source>take more passes of a lower depth</source>
            <translation>faça mais passes de menor profundidade</translation>
        </message>
        <message>
            <source>take one of them out</source>
            <translation>retire um deles</translation>
        </message>
        <message>
            <source>take one out</source>
            <translation>retire uma delas</translation>
        </message>
        <message>
            <source>take one out, or give them different consumables</source>
            <translation>retire uma delas, ou dê a elas consumíveis diferentes</translation>
        </message>
        <message>
            <source>take out R</source>
            <translation>retire R</translation>
        </message>
        <message>
            <source>take out inside = true</source>
            <translation>tire inside = true</translation>
        </message>
        <message>
            <source>take out the G4, or switch the power off with M5 before it</source>
            <translation>tire o G4, ou desligue a potência com M5 antes dele</translation>
        </message>
        <message>
            <source>take out the inner (</source>
            <translation>retire o ( interno</translation>
        </message>
        <message>
            <source>take out work_offset</source>
            <translation>tire work_offset</translation>
        </message>
        <message>
            <source>take out {word}</source>
            <translation>retire {word}</translation>
        </message>
        <message>
            <source>take text out of it</source>
            <translation>retire texto dele</translation>
        </message>
        <message>
            <source>take the kerf from the chart</source>
            <translation>use a largura do corte da tabela</translation>
        </message>
        <message>
            <source>take the line out; the arranged program lies in one work offset</source>
            <translation>retire a linha; o programa disposto usa um só sistema de coordenadas</translation>
        </message>
        <message>
            <source>take the others out</source>
            <translation>retire os outros</translation>
        </message>
        <message>
            <source>take up to 60 letters of a to z, digits, - and _, a letter or digit first</source>
            <translation>use até 60 letras de a a z, algarismos, - e _, primeiro letra ou algarismo</translation>
        </message>
        <message>
            <source>tapping became plain moves: the feed may be overridden, and nothing keeps it to the spindle</source>
            <translation>o rosqueamento virou movimentos simples: o avanço pode ser ajustado e nada o prende ao spindle</translation>
        </message>
        <message>
            <source>tcp:// of this computer, or tls://</source>
            <translation>tcp:// deste computador, ou tls://</translation>
        </message>
        <message>
            <source>teeth and bore</source>
            <translation>dentes e furo</translation>
        </message>
        <message>
            <source>test a torch, a laser, a jet or a wire</source>
            <translation>teste uma tocha, um laser, um jato ou um fio</translation>
        </message>
        <message>
            <source>test its axes one by one</source>
            <translation>teste os eixos um por um</translation>
        </message>
        <message>
            <source>test with the square, which changes none</source>
            <translation>teste com o quadrado, que não muda nenhum</translation>
        </message>
        <message>
            <source>that of the inner corners</source>
            <translation>o dos cantos internos</translation>
        </message>
        <message>
            <source>the $ command is not known</source>
            <translation>o comando $ não é conhecido</translation>
        </message>
        <message>
            <source>the N word must be the first of its line</source>
            <translation>a palavra N deve ser a primeira da linha</translation>
        </message>
        <message>
            <source>the NAME of material {number} names no material and thickness</source>
            <translation>o NAME do material {number} não indica material e espessura</translation>
        </message>
        <message>
            <source>the NEMA size</source>
            <translation>o tamanho NEMA</translation>
        </message>
        <message>
            <source>the O-word cannot be read</source>
            <translation>a palavra O não pode ser lida</translation>
        </message>
        <message>
            <source>the O-word is unknown</source>
            <translation>a palavra O é desconhecida</translation>
        </message>
        <message>
            <source>the P word is larger than the controller allows</source>
            <translation>a palavra P é maior do que o controlador permite</translation>
        </message>
        <message>
            <source>the USB board's controller</source>
            <translation>o controlador da placa USB</translation>
        </message>
        <message>
            <source>the actions between the moves would change</source>
            <translation>o que acontece entre os movimentos não seria o mesmo</translation>
        </message>
        <message>
            <source>the angle is not known at the zero of the work system</source>
            <translation>o ângulo não é conhecido no zero do sistema de coordenadas</translation>
        </message>
        <message>
            <source>the angle of the arc is so small that the controller would run a whole circle</source>
            <translation>o ângulo do arco é tão pequeno que o controlador faria um círculo completo</translation>
        </message>
        <message>
            <source>the arc begins at a place that is not known</source>
            <translation>o arco começa em um lugar que não é conhecido</translation>
        </message>
        <message>
            <source>the arc has neither I nor K nor R</source>
            <translation>o arco não tem I, nem K, nem R</translation>
        </message>
        <message>
            <source>the arc has neither {centre} nor {centre2} nor R</source>
            <translation>o arco não tem {centre}, nem {centre2}, nem R</translation>
        </message>
        <message>
            <source>the arc has no axis word of its plane</source>
            <translation>o arco não tem palavra de eixo do seu plano</translation>
        </message>
        <message>
            <source>the arc has no radius</source>
            <translation>o arco não tem raio</translation>
        </message>
        <message>
            <source>the arc in the concave corner cannot be reached by the tool without gouging</source>
            <translation>a ferramenta não alcança o arco no canto côncavo sem invadir a peça</translation>
        </message>
        <message>
            <source>the arc lacks its centre offset in the plane</source>
            <translation>falta ao arco o deslocamento do centro no plano</translation>
        </message>
        <message>
            <source>the arc needs {axis} or {axis2} in plane {name}</source>
            <translation>o arco precisa de {axis} ou {axis2} no plano {name}</translation>
        </message>
        <message>
            <source>the arc of a text needs a sweep</source>
            <translation>o arco de um texto precisa de um ângulo de abertura</translation>
        </message>
        <message>
            <source>the arc would go through another angle</source>
            <translation>o arco percorreria outro ângulo</translation>
        </message>
        <message>
            <source>the arc's centre is not as far from both its ends</source>
            <translation>o centro do arco não está à mesma distância das duas pontas</translation>
        </message>
        <message>
            <source>the arc's end does not lie on its circle</source>
            <translation>o fim do arco não está na sua circunferência</translation>
        </message>
        <message>
            <source>the arc's radius does not fit its end point</source>
            <translation>o raio do arco não combina com o ponto final</translation>
        </message>
        <message>
            <source>the arc's radius is not larger than the tool's</source>
            <translation>o raio do arco não é maior que o da ferramenta</translation>
        </message>
        <message>
            <source>the arc's radius is too small for its ends</source>
            <translation>o raio do arco é pequeno demais para as suas pontas</translation>
        </message>
        <message>
            <source>the arranged program has {count} cuts, not {wanted}</source>
            <translation>o programa disposto tem {count} cortes, e não {wanted}</translation>
        </message>
        <message>
            <source>the auxiliary port does not exist or is in use</source>
            <translation>a porta auxiliar não existe ou está em uso</translation>
        </message>
        <message>
            <source>the axes are X (radial) and Z (axial)</source>
            <translation>os eixos são X (radial) e Z (axial)</translation>
        </message>
        <message>
            <source>the back edge of the insert does not reach the profile</source>
            <translation>a aresta de trás da pastilha não alcança o perfil</translation>
        </message>
        <message>
            <source>the bar bends away from the tool</source>
            <translation>a barra se flexiona para longe da ferramenta</translation>
        </message>
        <message>
            <source>the bar is slender: it bends and chatters</source>
            <translation>a barra é esbelta: flexiona e vibra</translation>
        </message>
        <message>
            <source>the bar may turn in the chuck</source>
            <translation>a barra pode girar na placa</translation>
        </message>
        <message>
            <source>the bar sticks out of the chuck too far for its diameter</source>
            <translation>a barra sai demais da placa para o seu diâmetro</translation>
        </message>
        <message>
            <source>the bars' width</source>
            <translation>a largura das barras</translation>
        </message>
        <message>
            <source>the base's</source>
            <translation>a da base</translation>
        </message>
        <message>
            <source>the beam is never on during a cut</source>
            <translation>o feixe nunca está ligado onde deveria cortar</translation>
        </message>
        <message>
            <source>the blade does not reach so deep</source>
            <translation>o bedame não alcança essa profundidade</translation>
        </message>
        <message>
            <source>the blade is wider than the groove</source>
            <translation>o bedame é mais largo que o canal</translation>
        </message>
        <message>
            <source>the bore</source>
            <translation>o furo</translation>
        </message>
        <message>
            <source>the bore leaves the tool no room for a helix</source>
            <translation>o furo não deixa à ferramenta espaço para uma hélice</translation>
        </message>
        <message>
            <source>the buttons are not heard any more, so the machine is held: {error}</source>
            <translation>os botões não são mais lidos, por isso a máquina fica retida: {error}</translation>
        </message>
        <message>
            <source>the canned cycle is begun anew, at line {file_line}: G91 is in force</source>
            <translation>o ciclo fixo recomeça na linha {file_line}: G91 está em vigor</translation>
        </message>
        <message>
            <source>the certificate cannot be read</source>
            <translation>o certificado não pode ser lido</translation>
        </message>
        <message>
            <source>the certificate has an entry that no proof has</source>
            <translation>o certificado contém o que nenhuma prova tem</translation>
        </message>
        <message>
            <source>the certificate is of another version</source>
            <translation>o certificado é de outra versão</translation>
        </message>
        <message>
            <source>the certificate lacks an entry that a sender needs</source>
            <translation>falta no certificado o que o envio precisa</translation>
        </message>
        <message>
            <source>the certificate was changed after it was made</source>
            <translation>o certificado foi alterado depois de emitido</translation>
        </message>
        <message>
            <source>the certificate's findings are damaged</source>
            <translation>as ocorrências do certificado estão danificadas</translation>
        </message>
        <message>
            <source>the changed line would lead elsewhere than it must</source>
            <translation>a linha alterada levaria a um lugar diferente do devido</translation>
        </message>
        <message>
            <source>the changed program makes other moves</source>
            <translation>o programa alterado faz outros movimentos</translation>
        </message>
        <message>
            <source>the changed program would make other moves</source>
            <translation>o programa alterado faria outros movimentos</translation>
        </message>
        <message>
            <source>the character {found} would act as a command of its own or is not ASCII</source>
            <translation>o caractere {found} agiria como um comando ou não é ASCII</translation>
        </message>
        <message>
            <source>the chart has no consumable '{consumable}' for it</source>
            <translation>a tabela não tem o consumível '{consumable}' para isso</translation>
        </message>
        <message>
            <source>the chart has no kerf of {material} at this feed</source>
            <translation>a tabela não tem largura do corte de {material} com este avanço</translation>
        </message>
        <message>
            <source>the chart has no row of {process}</source>
            <translation>a tabela não tem linha de {process}</translation>
        </message>
        <message>
            <source>the chart has too many rows</source>
            <translation>a tabela tem linhas demais</translation>
        </message>
        <message>
            <source>the chart of {process} does not cover this thickness of {material}</source>
            <translation>a tabela de {process} não cobre esta espessura de {material}</translation>
        </message>
        <message>
            <source>the chart of {process} has no material '{material}'</source>
            <translation>a tabela de {process} não tem o material '{material}'</translation>
        </message>
        <message>
            <source>the checksum is wrong</source>
            <translation>a soma de verificação está errada</translation>
        </message>
        <message>
            <source>the circle's share of it</source>
            <translation>o que o círculo toma dela</translation>
        </message>
        <message>
            <source>the cluster gave no result: {kind}: {error}</source>
            <translation>o cluster não deu resultado: {kind}: {error}</translation>
        </message>
        <message>
            <source>the columns of MTEXT are set one below the other</source>
            <translation>as colunas do MTEXT são postas uma abaixo da outra</translation>
        </message>
        <message>
            <source>the command is allowed only while the machine is idle</source>
            <translation>o comando só é permitido com a máquina pronta</translation>
        </message>
        <message>
            <source>the command lacks its axis words</source>
            <translation>faltam as palavras de eixo do comando</translation>
        </message>
        <message>
            <source>the comment is not closed</source>
            <translation>o comentário não está fechado</translation>
        </message>
        <message>
            <source>the comment of a material lacks nu= or na=</source>
            <translation>no comentário de um material falta nu= ou na=</translation>
        </message>
        <message>
            <source>the comment of a material lacks {key}=</source>
            <translation>no comentário de um material falta {key}=</translation>
        </message>
        <message>
            <source>the compensated arc would have two radii</source>
            <translation>o arco compensado teria dois raios</translation>
        </message>
        <message>
            <source>the compensated tool cannot reach this corner without gouging</source>
            <translation>a ferramenta compensada não alcança este canto sem invadir a peça</translation>
        </message>
        <message>
            <source>the computer was late with a pulse and stopped after {written} writes, {at_ns:.3f} s from the begin; spindle, beam and drives are off, and steps may be lost</source>
            <translation>o computador se atrasou com um pulso e parou após {written} escritas no prazo, {at_ns:.3f} s depois do início; spindle, feixe e motores estão desligados, e passos podem ter sido perdidos</translation>
        </message>
        <message>
            <source>the configuration is not valid</source>
            <translation>a configuração não é válida</translation>
        </message>
        <message>
            <source>the connection service does not start</source>
            <translation>o processo da mesa de controle não inicia</translation>
        </message>
        <message>
            <source>the connection {session_file} is open, but its process does not answer</source>
            <translation>a conexão {session_file} está aberta, mas seu processo não responde</translation>
        </message>
        <message>
            <source>the console does not pass on {text}</source>
            <translation>o console não repassa {text}</translation>
        </message>
        <message>
            <source>the contour goes through the stock and sets a piece free that no tab holds</source>
            <translation>o contorno atravessa o bloco e solta um pedaço que nenhuma ponte segura</translation>
        </message>
        <message>
            <source>the controller accepts no jog while it is held</source>
            <translation>o controlador não aceita movimento manual enquanto está em pausa</translation>
        </message>
        <message>
            <source>the controller asks for a login</source>
            <translation>o controlador quer saber quem é você</translation>
        </message>
        <message>
            <source>the controller did not store the zero of {axis} in {system}</source>
            <translation>o zero de {axis} em {system} não foi aceito</translation>
        </message>
        <message>
            <source>the controller does not accept the password</source>
            <translation>o controlador não aceita a senha</translation>
        </message>
        <message>
            <source>the controller does not allow this to this user</source>
            <translation>o controlador não permite isto a este usuário</translation>
        </message>
        <message>
            <source>the controller does not answer any more</source>
            <translation>o controlador não responde mais</translation>
        </message>
        <message>
            <source>the controller does not come back from its reset</source>
            <translation>o controlador não volta do reset</translation>
        </message>
        <message>
            <source>the controller does not have this work system</source>
            <translation>o controlador não tem este sistema de coordenadas de trabalho</translation>
        </message>
        <message>
            <source>the controller does not know this command</source>
            <translation>o controlador não conhece este comando</translation>
        </message>
        <message>
            <source>the controller does not report ${number}: it was not compared</source>
            <translation>o controlador não informa ${number}: não foi comparado</translation>
        </message>
        <message>
            <source>the controller does not report its modes</source>
            <translation>o controlador não diz seus modos</translation>
        </message>
        <message>
            <source>the controller does not report its state</source>
            <translation>o controlador não informa o seu estado</translation>
        </message>
        <message>
            <source>the controller does not report its work system: {modes}</source>
            <translation>o controlador não informa o sistema de coordenadas: {modes}</translation>
        </message>
        <message>
            <source>the controller does not report its {system}</source>
            <translation>o controlador não informa: {system}</translation>
        </message>
        <message>
            <source>the controller does not report whether it uses mm or inches</source>
            <translation>o controlador não diz se informa em mm ou em polegadas</translation>
        </message>
        <message>
            <source>the controller has just started</source>
            <translation>o controlador acabou de iniciar</translation>
        </message>
        <message>
            <source>the controller has no memory left for O-words</source>
            <translation>o controlador não tem mais memória para palavras O</translation>
        </message>
        <message>
            <source>the controller has not kept its position through the reset at standstill</source>
            <translation>o controlador não manteve sua posição na reinicialização em repouso</translation>
        </message>
        <message>
            <source>the controller is idle but has not answered '{text}'</source>
            <translation>o controlador está pronto mas não respondeu '{text}'</translation>
        </message>
        <message>
            <source>the controller is locked by an alarm or a jog</source>
            <translation>o controlador está travado por um alarme ou movimento manual</translation>
        </message>
        <message>
            <source>the controller is locked: home the machine, or unlock it if its position is surely right</source>
            <translation>o controlador está travado: referencie a máquina, ou destrave-a se a posição está certa com certeza</translation>
        </message>
        <message>
            <source>the controller is starting</source>
            <translation>o controlador está iniciando</translation>
        </message>
        <message>
            <source>the controller of this machine has been started; it counts from the present position</source>
            <translation>o controlador desta máquina foi iniciado; ele conta a partir da posição atual</translation>
        </message>
        <message>
            <source>the controller of {machine} ended at its start</source>
            <translation>o controlador de {machine} terminou ao iniciar</translation>
        </message>
        <message>
            <source>the controller raised an alarm</source>
            <translation>o controlador entrou em alarme</translation>
        </message>
        <message>
            <source>the controller reads its lines without moving</source>
            <translation>o controlador lê as linhas sem se mover</translation>
        </message>
        <message>
            <source>the controller refused '{sent}' (error:{error})</source>
            <translation>o controlador recusou '{sent}' (error:{error})</translation>
        </message>
        <message>
            <source>the controller refused '{sent}': {meaning} (error:{error})</source>
            <translation>o controlador recusou '{sent}': {meaning} (error:{error})</translation>
        </message>
        <message>
            <source>the controller refused the line</source>
            <translation>o controlador recusou a linha</translation>
        </message>
        <message>
            <source>the controller refused {line}: {meaning} (error:{error})</source>
            <translation>o controlador recusou {line}: {meaning} (error:{error})</translation>
        </message>
        <message>
            <source>the controller reported: {report}</source>
            <translation>o controlador disse: {report}</translation>
        </message>
        <message>
            <source>the controller reports that it is homed, but too soon: another line than $H reached it</source>
            <translation>o controlador diz que a máquina está referenciada, mas cedo demais: chegou a ele outra linha em vez de $H</translation>
        </message>
        <message>
            <source>the controller restarted in the middle of the job</source>
            <translation>o controlador reiniciou no meio do trabalho</translation>
        </message>
        <message>
            <source>the controller restarted when its port was opened, so the machine's position is unknown: {why}</source>
            <translation>o controlador reiniciou ao abrir a porta, por isso a posição da máquina é desconhecida: {why}</translation>
        </message>
        <message>
            <source>the controller restarted when its port was opened; it counts from its present position</source>
            <translation>o controlador reiniciou quando a porta foi aberta; ele conta a partir de onde está</translation>
        </message>
        <message>
            <source>the controller restarted when its port was opened; it counts from its present position. Until it is unplugged no later opening restarts it</source>
            <translation>o controlador reiniciou quando sua porta foi aberta; ele conta a partir de onde está. Até ser desligado do cabo, nenhuma abertura seguinte o reinicia</translation>
        </message>
        <message>
            <source>the controller sleeps and its motors are off: unlock it, then home it or set its zero again</source>
            <translation>o controlador dorme e os motores estão desligados: destrave-o, depois referencie ou defina o zero de novo</translation>
        </message>
        <message>
            <source>the controller still waits for its new tool</source>
            <translation>o controlador ainda espera pela nova ferramenta</translation>
        </message>
        <message>
            <source>the controller stopped by a critical fault</source>
            <translation>o controlador parou por uma falha crítica</translation>
        </message>
        <message>
            <source>the controller waits for its new tool</source>
            <translation>o controlador espera pela nova ferramenta</translation>
        </message>
        <message>
            <source>the controller was reset before it could do that</source>
            <translation>o controlador foi reiniciado antes de poder fazer isso</translation>
        </message>
        <message>
            <source>the controller was reset while moving</source>
            <translation>o controlador foi reiniciado em movimento</translation>
        </message>
        <message>
            <source>the controller's configuration is not valid</source>
            <translation>a configuração do controlador não é válida</translation>
        </message>
        <message>
            <source>the controller's own test at power-up failed</source>
            <translation>o teste do próprio controlador ao ligar falhou</translation>
        </message>
        <message>
            <source>the controller's permanent memory failed</source>
            <translation>a memória permanente do controlador falhou</translation>
        </message>
        <message>
            <source>the converted program would continue after this</source>
            <translation>o programa convertido continuaria depois deste ponto</translation>
        </message>
        <message>
            <source>the converted program would not pass this point</source>
            <translation>o programa convertido não passaria por este ponto</translation>
        </message>
        <message>
            <source>the coordinate system in force may not be changed</source>
            <translation>o sistema de coordenadas em vigor não pode ser mudado</translation>
        </message>
        <message>
            <source>the corner is too large for its lines</source>
            <translation>o canto é grande demais para as suas retas</translation>
        </message>
        <message>
            <source>the corners of a clamp enclose nothing</source>
            <translation>os cantos de um grampo não delimitam nenhuma área</translation>
        </message>
        <message>
            <source>the corners of a rectangle's diagonal must differ in x and in y</source>
            <translation>os cantos da diagonal de um retângulo têm de diferir em x e em y</translation>
        </message>
        <message>
            <source>the count of copies is out of bounds</source>
            <translation>o número de cópias está fora dos limites</translation>
        </message>
        <message>
            <source>the crest of the thread lies below its floor</source>
            <translation>a crista da rosca fica abaixo do seu fundo</translation>
        </message>
        <message>
            <source>the curve has no length</source>
            <translation>a curva não tem comprimento</translation>
        </message>
        <message>
            <source>the curve is not smooth here</source>
            <translation>a curva não é suave aqui</translation>
        </message>
        <message>
            <source>the curve is open, a closed one is needed</source>
            <translation>a curva está aberta, é preciso uma fechada</translation>
        </message>
        <message>
            <source>the curve that {kind} follows is unknown</source>
            <translation>não se sabe o que {kind} segue</translation>
        </message>
        <message>
            <source>the curves of the drawing are too many and too wild for the tolerance</source>
            <translation>as curvas do desenho são muitas e irregulares demais para a tolerância</translation>
        </message>
        <message>
            <source>the cut</source>
            <translation>o corte</translation>
        </message>
        <message>
            <source>the cut begins without its pierce delay</source>
            <translation>o corte começa sem o tempo de perfuração</translation>
        </message>
        <message>
            <source>the cut begins without waiting for the spindle</source>
            <translation>o corte começa sem esperar o spindle</translation>
        </message>
        <message>
            <source>the cut goes into the part of another contour at X{x:.3f} Y{y:.3f}</source>
            <translation>o corte entra na peça de outro contorno em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>the cut goes into {hurt} outline(s) that other contours leave standing, most at X{x:.3f} Y{y:.3f}, by {radius_mm:.3f} mm</source>
            <translation>o corte entra em {hurt} linha(s) que outros contornos deixam intacta(s), mais em X{x:.3f} Y{y:.3f}, por {radius_mm:.3f} mm</translation>
        </message>
        <message>
            <source>the cut height is not the cut chart's</source>
            <translation>a altura de corte não é a da tabela de corte</translation>
        </message>
        <message>
            <source>the cut is too close to the sheet's edge</source>
            <translation>o corte chega perto demais da borda da chapa</translation>
        </message>
        <message>
            <source>the cut leads through the edge of a part that a contour leaves standing, {where}</source>
            <translation>o corte passa pela borda de uma peça que um contorno deixa em pé, {where}</translation>
        </message>
        <message>
            <source>the cut needs more power than the motor has</source>
            <translation>o corte exige mais potência do que o motor tem</translation>
        </message>
        <message>
            <source>the cut of the {tool} is deeper than it may be</source>
            <translation>o corte da ferramenta {tool} é mais fundo do que pode ser</translation>
        </message>
        <message>
            <source>the cutting force of {title} in turning is not in the table</source>
            <translation>a força de corte de {title} no torneamento não está na tabela</translation>
        </message>
        <message>
            <source>the cycle '{cycle}' takes no shapes of a drawing</source>
            <translation>o ciclo '{cycle}' não toma formas de um desenho</translation>
        </message>
        <message>
            <source>the cycle takes too many passes</source>
            <translation>o ciclo usa passes demais</translation>
        </message>
        <message>
            <source>the cycle uses a kerf of {kerf_mm:g} mm, the simulation the tool's diameter of {diameter_mm:g} mm</source>
            <translation>o corte é tido como de {kerf_mm:g} mm de largura, a simulação corta com os {diameter_mm:g} mm da ferramenta</translation>
        </message>
        <message>
            <source>the degree of the spline is out of bounds</source>
            <translation>o grau da spline está fora dos limites</translation>
        </message>
        <message>
            <source>the depth goes below the stock</source>
            <translation>a profundidade passa abaixo do bloco</translation>
        </message>
        <message>
            <source>the depth of cut is above the tool's</source>
            <translation>a profundidade de corte é maior que a da ferramenta</translation>
        </message>
        <message>
            <source>the depth over the key</source>
            <translation>a profundidade sobre a chaveta</translation>
        </message>
        <message>
            <source>the desk cannot be started: {error}</source>
            <translation>a mesa de controle não pode ser iniciada: {error}</translation>
        </message>
        <message>
            <source>the desk failed by a fault of its own</source>
            <translation>a mesa de controle falhou por um defeito próprio</translation>
        </message>
        <message>
            <source>the desk has ended</source>
            <translation>a conexão da janela terminou</translation>
        </message>
        <message>
            <source>the desk of {port} is not there, or was killed</source>
            <translation>a mesa de controle de {port} não existe ou foi encerrada</translation>
        </message>
        <message>
            <source>the device has accepted nothing for {limit:g} s; steps may be lost</source>
            <translation>o dispositivo não aceita nada há {limit:g} s; pode haver perda de passos</translation>
        </message>
        <message>
            <source>the diameter</source>
            <translation>o diâmetro</translation>
        </message>
        <message>
            <source>the diameter of its middle line</source>
            <translation>o diâmetro da linha média</translation>
        </message>
        <message>
            <source>the diameter of the points</source>
            <translation>o diâmetro das pontas</translation>
        </message>
        <message>
            <source>the diameter of the tool is not known</source>
            <translation>o diâmetro da ferramenta não é conhecido</translation>
        </message>
        <message>
            <source>the digits of {dialect} cannot hold this feed: F would be {written_mm_min:.4g} mm/min</source>
            <translation>os dígitos de {dialect} não comportam este avanço: F seria {written_mm_min:.4g} mm/min</translation>
        </message>
        <message>
            <source>the dimensions of the shape '{kind}' do not go together: {why}</source>
            <translation>as dimensões da forma '{kind}' não combinam: {why}</translation>
        </message>
        <message>
            <source>the disc</source>
            <translation>o disco</translation>
        </message>
        <message>
            <source>the document unpacks to too much</source>
            <translation>o documento descompactado é grande demais</translation>
        </message>
        <message>
            <source>the drawing '{deleted_drawing}' that it followed was deleted</source>
            <translation>o desenho '{deleted_drawing}' que ela seguia foi excluído</translation>
        </message>
        <message>
            <source>the drawing '{drawing}' holds an ellipse and no circle</source>
            <translation>o desenho '{drawing}' contém uma elipse e não um círculo</translation>
        </message>
        <message>
            <source>the drawing '{drawing}' holds more than one ellipse</source>
            <translation>o desenho '{drawing}' tem mais de uma elipse</translation>
        </message>
        <message>
            <source>the drawing '{drawing}' holds no circles and no points</source>
            <translation>o desenho '{drawing}' não contém círculos nem pontos</translation>
        </message>
        <message>
            <source>the drawing '{drawing}' holds no lines</source>
            <translation>o desenho '{drawing}' não tem linhas</translation>
        </message>
        <message>
            <source>the drawing '{drawing}' holds no single rectangle</source>
            <translation>o desenho '{drawing}' não contém um só retângulo</translation>
        </message>
        <message>
            <source>the drawing '{label}' does not lie flat</source>
            <translation>o desenho '{label}' não é plano</translation>
        </message>
        <message>
            <source>the drawing '{label}' holds a line that is no ellipse</source>
            <translation>o desenho '{label}' tem uma linha que não é elipse</translation>
        </message>
        <message>
            <source>the drawing declares XML entities that are longer than a short text</source>
            <translation>o desenho declara entidades que representam mais do que um texto curto</translation>
        </message>
        <message>
            <source>the drawing has no closed outline</source>
            <translation>o desenho não tem nenhum contorno fechado</translation>
        </message>
        <message>
            <source>the drawing has no curves on a layer '{name}'</source>
            <translation>o desenho não tem curvas em uma camada '{name}'</translation>
        </message>
        <message>
            <source>the drawing has outlines beside each other</source>
            <translation>o desenho tem contornos um ao lado do outro</translation>
        </message>
        <message>
            <source>the drawing has too many elements with those that it uses</source>
            <translation>o desenho tem elementos demais, contando os que ele usa</translation>
        </message>
        <message>
            <source>the drawing has too many rules of style</source>
            <translation>o desenho tem regras de estilo demais</translation>
        </message>
        <message>
            <source>the drawing has too many {of_what}</source>
            <translation>o desenho tem demais: {of_what}</translation>
        </message>
        <message>
            <source>the drawing has too much text</source>
            <translation>o desenho tem texto demais</translation>
        </message>
        <message>
            <source>the drawing holds no curves</source>
            <translation>o desenho não contém curvas</translation>
        </message>
        <message>
            <source>the drawing reaches beyond the stock</source>
            <translation>o desenho passa do material</translation>
        </message>
        <message>
            <source>the drawing would become too many objects</source>
            <translation>o desenho viraria objetos demais</translation>
        </message>
        <message>
            <source>the drawing {file} has no chains for the shape '{name}': {words}</source>
            <translation>o desenho {file} não tem cadeias para a forma '{name}': {words}</translation>
        </message>
        <message>
            <source>the drawing {file}: {words}: {count}</source>
            <translation>o desenho {file}: {words}: {count}</translation>
        </message>
        <message>
            <source>the drawing {form_file} is damaged, a part of it may be missing: {damage}</source>
            <translation>o desenho {form_file} está danificado, pode faltar parte dele: {damage}</translation>
        </message>
        <message>
            <source>the drawing's unit</source>
            <translation>a unidade do desenho</translation>
        </message>
        <message>
            <source>the drawings lie at heights from Z{least_heights:.4g} to Z{most_heights:.4g} mm; all depths count from the top of the stock</source>
            <translation>os desenhos estão em alturas de Z{least_heights:.4g} a Z{most_heights:.4g} mm; todas as profundidades contam a partir do topo do bloco</translation>
        </message>
        <message>
            <source>the drill does not reach so deep</source>
            <translation>a broca não alcança essa profundidade</translation>
        </message>
        <message>
            <source>the ears</source>
            <translation>as orelhas</translation>
        </message>
        <message>
            <source>the edited program has no job</source>
            <translation>o programa editado não tem trabalho</translation>
        </message>
        <message>
            <source>the elements picked of '{drawing}' no longer exist</source>
            <translation>o que foi escolhido de '{drawing}' não existe mais</translation>
        </message>
        <message>
            <source>the ellipse in '{drawing}' is open</source>
            <translation>a elipse em '{drawing}' está aberta</translation>
        </message>
        <message>
            <source>the ellipse's ends are tighter than the tool, where similar ellipses would cut into the wall</source>
            <translation>as pontas da elipse são mais fechadas que a ferramenta, e elipses semelhantes cortariam a parede ali</translation>
        </message>
        <message>
            <source>the emergency stop is active</source>
            <translation>a parada de emergência está ativa</translation>
        </message>
        <message>
            <source>the emergency stop was pressed</source>
            <translation>a parada de emergência foi acionada</translation>
        </message>
        <message>
            <source>the ends of the legs</source>
            <translation>as pontas das abas</translation>
        </message>
        <message>
            <source>the entry arc of the compensation is not larger than the tool's radius</source>
            <translation>o arco de entrada da compensação não é maior que o raio da ferramenta</translation>
        </message>
        <message>
            <source>the entry move of the compensation is not longer than the tool's radius</source>
            <translation>o movimento de entrada da compensação não é mais longo que o raio da ferramenta</translation>
        </message>
        <message>
            <source>the expression cannot be read</source>
            <translation>a expressão não pode ser lida</translation>
        </message>
        <message>
            <source>the expression divides by 0</source>
            <translation>a expressão divide por 0</translation>
        </message>
        <message>
            <source>the expression divides by zero</source>
            <translation>a expressão divide por zero</translation>
        </message>
        <message>
            <source>the expression has an operation that is not known</source>
            <translation>a expressão tem uma operação desconhecida</translation>
        </message>
        <message>
            <source>the expression is nested too deep</source>
            <translation>a expressão tem níveis demais</translation>
        </message>
        <message>
            <source>the expression is not closed</source>
            <translation>a expressão não está fechada</translation>
        </message>
        <message>
            <source>the expression's result is not a finite number</source>
            <translation>o resultado da expressão não é um número finito</translation>
        </message>
        <message>
            <source>the face lies before the stock</source>
            <translation>a face fica à frente do material</translation>
        </message>
        <message>
            <source>the factor must be above 0</source>
            <translation>o fator deve ser maior que 0</translation>
        </message>
        <message>
            <source>the feed asks more of {name} than its highest rate</source>
            <translation>o avanço pede de {name} mais que a sua velocidade máxima</translation>
        </message>
        <message>
            <source>the feed does not follow the spindle: choose a machine whose controller has G33</source>
            <translation>o avanço não segue o fuso: escolha uma máquina cujo controlador tenha G33</translation>
        </message>
        <message>
            <source>the feed does not follow the spindle: write thread passes as G01 at F = pitch * rpm / 60, for a lathe that begins each run of G01 at the encoder's index (mini-lathe:thread_start=index)</source>
            <translation>o avanço não acompanha o fuso: escreva os passes de rosca como G01 com F = passo * rpm / 60, para um torno que começa cada sequência de G01 no índice do encoder (mini-lathe:thread_start=index)</translation>
        </message>
        <message>
            <source>the feed is higher than the machine's axes can go</source>
            <translation>o avanço é maior do que os eixos da máquina conseguem</translation>
        </message>
        <message>
            <source>the feed is not the cut chart's</source>
            <translation>o avanço não é o da tabela de corte</translation>
        </message>
        <message>
            <source>the feed per revolution is above the tool's</source>
            <translation>o avanço por volta é maior que o da ferramenta</translation>
        </message>
        <message>
            <source>the feed per revolution is below the tool's</source>
            <translation>o avanço por volta é menor que o da ferramenta</translation>
        </message>
        <message>
            <source>the feed would be another</source>
            <translation>o avanço seria outro</translation>
        </message>
        <message>
            <source>the feed would round to 0</source>
            <translation>o avanço seria arredondado para 0</translation>
        </message>
        <message>
            <source>the file cannot be created</source>
            <translation>o arquivo não pode ser criado</translation>
        </message>
        <message>
            <source>the file cannot be deleted</source>
            <translation>o arquivo não pode ser apagado</translation>
        </message>
        <message>
            <source>the file cannot be opened</source>
            <translation>o arquivo não pode ser aberto</translation>
        </message>
        <message>
            <source>the file cannot be read</source>
            <translation>o arquivo não pode ser lido</translation>
        </message>
        <message>
            <source>the file cannot be read: {why}</source>
            <translation>o arquivo não pode ser lido: {why}</translation>
        </message>
        <message>
            <source>the file cannot be renamed</source>
            <translation>o arquivo não pode ser renomeado</translation>
        </message>
        <message>
            <source>the file could not be handed out</source>
            <translation>o arquivo não pôde ser entregue</translation>
        </message>
        <message>
            <source>the file could not be loaded</source>
            <translation>o arquivo não pôde ser recebido</translation>
        </message>
        <message>
            <source>the file does not exist</source>
            <translation>o arquivo não existe</translation>
        </message>
        <message>
            <source>the file ended</source>
            <translation>o arquivo terminou</translation>
        </message>
        <message>
            <source>the file gives no size in mm or inches: {dpi:g} pixels an inch are assumed</source>
            <translation>o arquivo não dá um tamanho em mm ou polegadas: são usados {dpi:g} pixels por polegada</translation>
        </message>
        <message>
            <source>the file gives no size of its sheet: zero is the upper left corner</source>
            <translation>o arquivo não dá o tamanho da folha: o zero é o canto superior esquerdo</translation>
        </message>
        <message>
            <source>the file has no pulse letter</source>
            <translation>o arquivo não tem letra de pulso</translation>
        </message>
        <message>
            <source>the file has too many materials</source>
            <translation>o arquivo tem materiais demais</translation>
        </message>
        <message>
            <source>the file has too many pulses to be shown</source>
            <translation>o arquivo tem pulsos demais para ser mostrado</translation>
        </message>
        <message>
            <source>the file holds no object</source>
            <translation>o arquivo não contém um objeto</translation>
        </message>
        <message>
            <source>the file is empty</source>
            <translation>o arquivo está vazio</translation>
        </message>
        <message>
            <source>the file is read-only</source>
            <translation>o arquivo é somente leitura</translation>
        </message>
        <message>
            <source>the file is too large</source>
            <translation>o arquivo é grande demais</translation>
        </message>
        <message>
            <source>the file needs a strip_height above 0 and a list of items</source>
            <translation>o arquivo precisa de um strip_height maior que 0 e de uma lista de items</translation>
        </message>
        <message>
            <source>the file of the drawing has changed</source>
            <translation>o arquivo do desenho mudou</translation>
        </message>
        <message>
            <source>the file of the drawing is not there any more</source>
            <translation>o arquivo do desenho não está mais lá</translation>
        </message>
        <message>
            <source>the file system can only be read</source>
            <translation>o sistema de arquivos só pode ser lido</translation>
        </message>
        <message>
            <source>the file system cannot be formatted</source>
            <translation>o sistema de arquivos não pode ser formatado</translation>
        </message>
        <message>
            <source>the file system cannot be mounted</source>
            <translation>o sistema de arquivos não pode ser montado</translation>
        </message>
        <message>
            <source>the file system could not be formatted</source>
            <translation>o sistema de arquivos não pôde ser formatado</translation>
        </message>
        <message>
            <source>the file system is busy</source>
            <translation>o sistema de arquivos está ocupado</translation>
        </message>
        <message>
            <source>the file was changed while it was read</source>
            <translation>o arquivo foi alterado enquanto era lido</translation>
        </message>
        <message>
            <source>the first line of an order names its columns: drawing and template, and material, thickness_mm, count</source>
            <translation>a primeira linha de um pedido nomeia suas colunas: drawing e template, e material, thickness_mm, count</translation>
        </message>
        <message>
            <source>the first {0} are drawn</source>
            <translation>os primeiros {0} são desenhados</translation>
        </message>
        <message>
            <source>the flanges' width</source>
            <translation>a largura das abas</translation>
        </message>
        <message>
            <source>the floor of the groove lies outside the material</source>
            <translation>o fundo do canal fica fora do material</translation>
        </message>
        <message>
            <source>the floor of the thread crosses the axis</source>
            <translation>o fundo da rosca cruza o eixo</translation>
        </message>
        <message>
            <source>the folder belongs to another user</source>
            <translation>a pasta pertence a outro usuário</translation>
        </message>
        <message>
            <source>the folder cannot be deleted</source>
            <translation>a pasta não pode ser apagada</translation>
        </message>
        <message>
            <source>the folder cannot be opened</source>
            <translation>a pasta não pode ser aberta</translation>
        </message>
        <message>
            <source>the folder does not exist</source>
            <translation>a pasta não existe</translation>
        </message>
        <message>
            <source>the folder is a link</source>
            <translation>a pasta é um link</translation>
        </message>
        <message>
            <source>the folder of sessions cannot be used: {error}</source>
            <translation>a pasta das sessões não pode ser usada: {error}</translation>
        </message>
        <message>
            <source>the font '{family}' has no style '{style}'</source>
            <translation>a fonte '{family}' não tem o estilo '{style}'</translation>
        </message>
        <message>
            <source>the font '{font}' is not here; its text is set in {other}</source>
            <translation>a fonte '{font}' não está aqui; o texto é composto em {other}</translation>
        </message>
        <message>
            <source>the font '{font}' lacks characters of the text</source>
            <translation>faltam na fonte '{font}' caracteres do texto</translation>
        </message>
        <message>
            <source>the font '{font}' lacks {names}; they are left out</source>
            <translation>a fonte '{font}' não tem {names}; esses caracteres são omitidos</translation>
        </message>
        <message>
            <source>the font is damaged: {why}</source>
            <translation>a fonte está danificada: {why}</translation>
        </message>
        <message>
            <source>the fonts of {count} texts lack letters, which are left out: {names}</source>
            <translation>faltam letras nas fontes de {count} textos, que são omitidas: {names}</translation>
        </message>
        <message>
            <source>the front edge of the insert does not reach a flat face</source>
            <translation>a aresta da frente da pastilha não alcança uma face plana</translation>
        </message>
        <message>
            <source>the front edge of the insert does not reach the profile</source>
            <translation>a aresta da frente da pastilha não alcança o perfil</translation>
        </message>
        <message>
            <source>the grid has too many holes</source>
            <translation>a grade tem furos demais</translation>
        </message>
        <message>
            <source>the head goes over a piece that is free and may stand up</source>
            <translation>o cabeçote passa sobre uma peça solta que pode estar levantada</translation>
        </message>
        <message>
            <source>the head's</source>
            <translation>o da cabeça</translation>
        </message>
        <message>
            <source>the head's width</source>
            <translation>a largura da cabeça</translation>
        </message>
        <message>
            <source>the height</source>
            <translation>a altura</translation>
        </message>
        <message>
            <source>the heights cannot be read: {reason}</source>
            <translation>as alturas não podem ser lidas: {reason}</translation>
        </message>
        <message>
            <source>the heights do not fit their box</source>
            <translation>as alturas não cabem na sua caixa</translation>
        </message>
        <message>
            <source>the highest spindle speed, which every S is scaled by</source>
            <translation>a rotação máxima do spindle, pela qual todo S é escalado</translation>
        </message>
        <message>
            <source>the holder</source>
            <translation>o porta-ferramenta</translation>
        </message>
        <message>
            <source>the holder of the tool touches the part</source>
            <translation>o suporte da ferramenta toca a peça</translation>
        </message>
        <message>
            <source>the holder of the {tool} tool goes into stock</source>
            <translation>o porta-ferramenta da ferramenta {tool} entra no material</translation>
        </message>
        <message>
            <source>the hole for the head</source>
            <translation>o furo para a cabeça</translation>
        </message>
        <message>
            <source>the hole is too narrow for the boring bar</source>
            <translation>o furo é estreito demais para a barra de mandrilar</translation>
        </message>
        <message>
            <source>the inner one</source>
            <translation>o interno</translation>
        </message>
        <message>
            <source>the insert '{code}' has no {name} of ISO 1832</source>
            <translation>a pastilha '{code}' não tem {name} da ISO 1832</translation>
        </message>
        <message>
            <source>the insert must fill 1 to 179 degrees from back_deg to front_deg: it fills {angle:g}</source>
            <translation>a pastilha deve ocupar de 1 a 179 graus entre back_deg e front_deg: ocupa {angle:g}</translation>
        </message>
        <message>
            <source>the job cannot be read: {error}</source>
            <translation>o trabalho não pode ser lido: {error}</translation>
        </message>
        <message>
            <source>the job has a program for each of {count} tools, one after the other</source>
            <translation>o trabalho tem um programa para cada uma das {count} ferramentas, um após o outro</translation>
        </message>
        <message>
            <source>the job has ended: {outcome}</source>
            <translation>o trabalho terminou: {outcome}</translation>
        </message>
        <message>
            <source>the job has no operation</source>
            <translation>o trabalho não tem operação</translation>
        </message>
        <message>
            <source>the job has no operations</source>
            <translation>o trabalho não tem operações</translation>
        </message>
        <message>
            <source>the job has {of_what}</source>
            <translation>o trabalho tem {of_what}</translation>
        </message>
        <message>
            <source>the job is about to resume</source>
            <translation>o trabalho está prestes a continuar</translation>
        </message>
        <message>
            <source>the job is too long for a file that people read</source>
            <translation>o trabalho é longo demais para um arquivo que pessoas leem</translation>
        </message>
        <message>
            <source>the job names no material, so the chart gives no tool</source>
            <translation>o trabalho não indica material, por isso a tabela não dá ferramenta</translation>
        </message>
        <message>
            <source>the job of {process} names no material and has no tool</source>
            <translation>o trabalho de {process} não indica material e não tem ferramenta</translation>
        </message>
        <message>
            <source>the job still runs, on {port}</source>
            <translation>o trabalho ainda está em andamento, em {port}</translation>
        </message>
        <message>
            <source>the job was deleted</source>
            <translation>o trabalho foi apagado</translation>
        </message>
        <message>
            <source>the job was sent without a machine profile, so no way back can be checked</source>
            <translation>o trabalho foi enviado sem perfil de máquina, portanto nenhum caminho de volta pode ser verificado</translation>
        </message>
        <message>
            <source>the job's machine profile cannot be read: {error}</source>
            <translation>o perfil de máquina do trabalho não pode ser lido: {error}</translation>
        </message>
        <message>
            <source>the job's own program has changed since this one was edited</source>
            <translation>o programa do próprio trabalho mudou desde que este foi editado</translation>
        </message>
        <message>
            <source>the jog came too late to be safe</source>
            <translation>o movimento manual chegou tarde demais para ser seguro</translation>
        </message>
        <message>
            <source>the jog command lacks its `=` or holds a forbidden word</source>
            <translation>falta `=` no comando de jog, ou ele tem uma palavra proibida</translation>
        </message>
        <message>
            <source>the jog ends outside the machine's travel</source>
            <translation>o movimento manual termina fora do curso da máquina</translation>
        </message>
        <message>
            <source>the jog was cancelled</source>
            <translation>o movimento manual foi cancelado</translation>
        </message>
        <message>
            <source>the jog was stopped: its button was not heard of for {lapse_s:g} s</source>
            <translation>o movimento manual foi parado: sem notícia do botão por {lapse_s:g} s</translation>
        </message>
        <message>
            <source>the jogs before this one are not done yet</source>
            <translation>os movimentos manuais anteriores ainda não terminaram</translation>
        </message>
        <message>
            <source>the journal cannot be read: {error}</source>
            <translation>o diário não pode ser lido: {error}</translation>
        </message>
        <message>
            <source>the journal cannot be written ({trouble}): the job goes on to {place} and is held there; make room on the disk of {folder}</source>
            <translation>o diário não pode ser gravado ({trouble}): o trabalho segue até {place} e fica retido ali; libere espaço no disco de {folder}</translation>
        </message>
        <message>
            <source>the journal could not be closed ({error}): the job will be listed as killed</source>
            <translation>o diário não pôde ser encerrado ({error}): ele falará de um trabalho interrompido à força</translation>
        </message>
        <message>
            <source>the journal is written again: a job that was held for it can be resumed</source>
            <translation>o diário voltou a ser gravado: um trabalho que foi retido por causa dele pode ser retomado</translation>
        </message>
        <message>
            <source>the journal lacks its beginning, or is none</source>
            <translation>falta o começo do diário, ou o arquivo não é um diário</translation>
        </message>
        <message>
            <source>the journal of the job cannot be written</source>
            <translation>o diário do trabalho não pode ser gravado</translation>
        </message>
        <message>
            <source>the journal of the job cannot be written: {why}</source>
            <translation>o diário do trabalho não pode ser gravado: {why}</translation>
        </message>
        <message>
            <source>the kerf closes a narrow place in the outline of part {number}, which begins at X{x:.3f} Y{y:.3f}</source>
            <translation>a largura do corte fecha um lugar estreito no contorno da peça {number}, que começa em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>the kerf goes beyond the drawing</source>
            <translation>o corte passa do desenho</translation>
        </message>
        <message>
            <source>the kerf goes beyond the drawing into a part</source>
            <translation>o corte passa do desenho e entra em uma peça</translation>
        </message>
        <message>
            <source>the kerf is wider than a place in the hole of part {number} that begins at X{x:.3f} Y{y:.3f}</source>
            <translation>a largura do corte é maior que um lugar no furo da peça {number} que começa em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>the kerf is wider than hole {number} at X{x:.3f} Y{y:.3f}</source>
            <translation>a largura do corte é maior que o furo {number} em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>the kerf of {kerf_mm:g} mm</source>
            <translation>a largura do corte de {kerf_mm:g} mm</translation>
        </message>
        <message>
            <source>the kerf test is too small for its kerf and leads</source>
            <translation>o teste da largura do corte é pequeno demais para o corte e para as entradas e saídas</translation>
        </message>
        <message>
            <source>the kernels were not compiled in advance: {said}</source>
            <translation>o código rápido não foi compilado antes: {said}</translation>
        </message>
        <message>
            <source>the key {name} is missing</source>
            <translation>falta a chave {name}</translation>
        </message>
        <message>
            <source>the key's width</source>
            <translation>a largura da chaveta</translation>
        </message>
        <message>
            <source>the knots and poles of a spline of the solid do not belong together</source>
            <translation>os nós e polos de uma spline do sólido não correspondem</translation>
        </message>
        <message>
            <source>the largest disc of the {tool} tool stands more than a pitch above its tip: it cuts no thread</source>
            <translation>o maior disco da ferramenta {tool} fica mais de um passo acima da ponta: ela não corta rosca</translation>
        </message>
        <message>
            <source>the last line has no end</source>
            <translation>a última linha não tem fim</translation>
        </message>
        <message>
            <source>the lathe cannot be stopped over its link: it runs on for {0} s, to X{1} Z{2}</source>
            <translation>o torno não pode ser parado pela sua ligação: ele continua por {0} s, até X{1} Z{2}</translation>
        </message>
        <message>
            <source>the lathe finishes a move that it has begun: switch it off, then set its zero again</source>
            <translation>um movimento que o torno começou continua: desligue-o e depois defina o zero de novo</translation>
        </message>
        <message>
            <source>the lathe is in automatic mode and cannot be jogged: {0}</source>
            <translation>o torno está em modo automático e não pode ser movido à mão: {0}</translation>
        </message>
        <message>
            <source>the lathe is in automatic mode, or locked by an alarm</source>
            <translation>o torno está no modo automático, ou travado por um alarme</translation>
        </message>
        <message>
            <source>the lathe jogs at up to {0} mm/min, or at {1}: it takes the slower one</source>
            <translation>o torno se move à mão a até {0} mm/min, ou a {1}: fica a menor</translation>
        </message>
        <message>
            <source>the lathe's timer makes a lead of {lead:.4f} mm, not {wanted:.4f} mm: over the thread {off:.3f} mm; at {rpm:.2f} rpm it is right</source>
            <translation>o temporizador do torno faz um avanço por volta de {lead:.4f} mm, e não {wanted:.4f} mm: na rosca toda {off:.3f} mm; a {rpm:.2f} rpm fica certo</translation>
        </message>
        <message>
            <source>the layer of a profile must hold one chain</source>
            <translation>a camada de um perfil deve conter uma só cadeia</translation>
        </message>
        <message>
            <source>the lead of '{text}' is no whole number of pitches</source>
            <translation>o avanço por volta de '{text}' não é um número inteiro de passos</translation>
        </message>
        <message>
            <source>the leads fit nowhere in the scrap; the closest obstacle is {name} at X{x:.3f} Y{y:.3f}</source>
            <translation>as entradas e saídas não cabem em lugar nenhum da sobra; o obstáculo mais próximo é {name} em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>the legs' width</source>
            <translation>a largura das abas</translation>
        </message>
        <message>
            <source>the length</source>
            <translation>o comprimento</translation>
        </message>
        <message>
            <source>the length of the tool before is in force after the change</source>
            <translation>o comprimento da ferramenta anterior está em vigor depois da troca</translation>
        </message>
        <message>
            <source>the length offset of tool {tool_number} is unknown; 0 is assumed</source>
            <translation>a correção de comprimento da ferramenta {tool_number} não é conhecida, vale como 0</translation>
        </message>
        <message>
            <source>the length offset of tool {tool} is not known</source>
            <translation>a correção de comprimento da ferramenta {tool} não é conhecida</translation>
        </message>
        <message>
            <source>the letters go farther than {axis} can travel</source>
            <translation>as letras vão além do curso de {axis}</translation>
        </message>
        <message>
            <source>the letters move {axis}, which this machine does not have</source>
            <translation>as letras movem {axis}, que esta máquina não tem</translation>
        </message>
        <message>
            <source>the letters of the text have no {part}</source>
            <translation>as letras do texto não têm {part}</translation>
        </message>
        <message>
            <source>the library has no shape '{kind}'</source>
            <translation>a biblioteca não tem a forma '{kind}'</translation>
        </message>
        <message>
            <source>the library has too many tools</source>
            <translation>a biblioteca tem ferramentas demais</translation>
        </message>
        <message>
            <source>the line before is not done yet</source>
            <translation>a linha anterior ainda não terminou</translation>
        </message>
        <message>
            <source>the line does not end where it began</source>
            <translation>a linha não termina onde começou</translation>
        </message>
        <message>
            <source>the line does not fit into the controller's buffer</source>
            <translation>a linha não cabe no buffer do controlador</translation>
        </message>
        <message>
            <source>the line does not fit the buffer of {language}</source>
            <translation>a linha não cabe no buffer de {language}</translation>
        </message>
        <message>
            <source>the line ended too early</source>
            <translation>a linha terminou cedo demais</translation>
        </message>
        <message>
            <source>the line has no length</source>
            <translation>a linha não tem comprimento</translation>
        </message>
        <message>
            <source>the line holds a real-time command byte</source>
            <translation>a linha tem um byte ao qual o controlador reage onde quer que esteja</translation>
        </message>
        <message>
            <source>the line in the concave corner cannot be reached by the tool without gouging</source>
            <translation>a ferramenta não alcança a reta no canto côncavo sem invadir a peça</translation>
        </message>
        <message>
            <source>the line is longer than {firmware} can read</source>
            <translation>a linha é mais longa do que {firmware} consegue ler</translation>
        </message>
        <message>
            <source>the line is too long</source>
            <translation>a linha é longa demais</translation>
        </message>
        <message>
            <source>the line is too long for the machine</source>
            <translation>a linha é longa demais para a máquina</translation>
        </message>
        <message>
            <source>the line jumps to a line number</source>
            <translation>a linha salta para um número de linha</translation>
        </message>
        <message>
            <source>the line map does not fit the lines</source>
            <translation>o mapa de linhas não combina com as linhas</translation>
        </message>
        <message>
            <source>the line number is not between 0 and 9999999</source>
            <translation>o número da linha não está entre 0 e 9999999</translation>
        </message>
        <message>
            <source>the line number is out of range</source>
            <translation>o número da linha está fora da faixa</translation>
        </message>
        <message>
            <source>the line reads the machine's position, which the edit would change</source>
            <translation>a linha lê onde a máquina está, e a edição mudaria isso</translation>
        </message>
        <message>
            <source>the lines after it</source>
            <translation>o que vem depois disso</translation>
        </message>
        <message>
            <source>the lines after this tool change cannot run on their own</source>
            <translation>as linhas depois desta troca de ferramenta não se sustentam sozinhas</translation>
        </message>
        <message>
            <source>the lines are being fitted</source>
            <translation>as linhas estão sendo ajustadas</translation>
        </message>
        <message>
            <source>the lines have different numbers of heights</source>
            <translation>as linhas têm quantidades diferentes de alturas</translation>
        </message>
        <message>
            <source>the lines of a retract are not at the controller</source>
            <translation>ninguém conduz a ferramenta ao longo do seu corte; as linhas do programa para isso não estão no controlador</translation>
        </message>
        <message>
            <source>the lines that would be sent mean another path than the program</source>
            <translation>as linhas que seriam enviadas descrevem outro percurso que o programa</translation>
        </message>
        <message>
            <source>the lines to send are not those that were proven</source>
            <translation>as linhas a enviar não são as que foram verificadas</translation>
        </message>
        <message>
            <source>the lines to send were made from another program</source>
            <translation>as linhas a enviar foram feitas de outro programa</translation>
        </message>
        <message>
            <source>the link to {name} broke: {error}</source>
            <translation>a ligação com {name} caiu: {error}</translation>
        </message>
        <message>
            <source>the locks of the order contradict each other</source>
            <translation>as travas da ordem se contradizem</translation>
        </message>
        <message>
            <source>the machine can do no better with this tool</source>
            <translation>a máquina não consegue melhor com esta ferramenta</translation>
        </message>
        <message>
            <source>the machine does not end its homing</source>
            <translation>a máquina não termina o referenciamento</translation>
        </message>
        <message>
            <source>the machine does not home: {meaning} (error:{error})</source>
            <translation>a máquina não referencia: {meaning} (error:{error})</translation>
        </message>
        <message>
            <source>the machine finds its own zero</source>
            <translation>a máquina procura o seu próprio zero</translation>
        </message>
        <message>
            <source>the machine has no axes X and Z</source>
            <translation>a máquina não tem os eixos X e Z</translation>
        </message>
        <message>
            <source>the machine has no such spindle</source>
            <translation>a máquina não tem esse fuso</translation>
        </message>
        <message>
            <source>the machine has no work offsets</source>
            <translation>a máquina não tem sistemas de coordenadas de trabalho</translation>
        </message>
        <message>
            <source>the machine has no {name} coolant</source>
            <translation>a máquina não tem refrigeração {name}</translation>
        </message>
        <message>
            <source>the machine has one spindle, number 0</source>
            <translation>a máquina tem um só spindle, o de número 0</translation>
        </message>
        <message>
            <source>the machine is at rest, spindle and outputs are off, its position is kept (the reset cleared G92 and tool length)</source>
            <translation>a máquina está parada, spindle e saídas desligados, a posição se mantém (o reset apagou G92 e o comprimento da ferramenta)</translation>
        </message>
        <message>
            <source>the machine is homed</source>
            <translation>a máquina está referenciada</translation>
        </message>
        <message>
            <source>the machine is not at rest</source>
            <translation>a máquina não está em repouso</translation>
        </message>
        <message>
            <source>the machine is not at standstill</source>
            <translation>a máquina não está parada</translation>
        </message>
        <message>
            <source>the machine is not at the begin of the retract</source>
            <translation>a máquina não está onde o caminho de volta começa</translation>
        </message>
        <message>
            <source>the machine is not held</source>
            <translation>a máquina não está em pausa</translation>
        </message>
        <message>
            <source>the machine is not idle</source>
            <translation>a máquina não está pronta</translation>
        </message>
        <message>
            <source>the machine is not in alarm</source>
            <translation>a máquina não está em alarme</translation>
        </message>
        <message>
            <source>the machine is not on the path of the lines that it has</source>
            <translation>a máquina não está no percurso das linhas que recebeu</translation>
        </message>
        <message>
            <source>the machine is not on the program's path: a line was damaged on its way</source>
            <translation>a máquina não está no caminho do programa: uma linha foi danificada na transmissão</translation>
        </message>
        <message>
            <source>the machine is not where the program paused</source>
            <translation>a máquina não está onde o programa pausou</translation>
        </message>
        <message>
            <source>the machine is still slowing down</source>
            <translation>a máquina ainda está freando</translation>
        </message>
        <message>
            <source>the machine jogs</source>
            <translation>a máquina está em movimento manual</translation>
        </message>
        <message>
            <source>the machine jogs only while it is idle</source>
            <translation>o movimento manual só funciona com a máquina pronta</translation>
        </message>
        <message>
            <source>the machine left the program's path: a line was damaged on its way, or the controller restarted unheard</source>
            <translation>a máquina saiu do caminho do programa: uma linha foi danificada na transmissão, ou o controlador reiniciou sem que se ouvisse</translation>
        </message>
        <message>
            <source>the machine must be homed before it may move</source>
            <translation>a máquina precisa ser referenciada antes de se mover</translation>
        </message>
        <message>
            <source>the machine must be homed first</source>
            <translation>a máquina precisa ser referenciada antes</translation>
        </message>
        <message>
            <source>the machine was stopped at once</source>
            <translation>a máquina foi parada de imediato</translation>
        </message>
        <message>
            <source>the machine's buttons lead nothing back any more: {error}</source>
            <translation>os botões da máquina não conduzem mais nada de volta: {error}</translation>
        </message>
        <message>
            <source>the machine's controller does not have it: take it out, or cut the program in two there</source>
            <translation>o controlador da máquina não o tem: retire-o, ou divida o programa ali</translation>
        </message>
        <message>
            <source>the machine's position is unknown</source>
            <translation>a posição da máquina é desconhecida</translation>
        </message>
        <message>
            <source>the machine's position is unknown: look that spindle and outputs are off, then home it or set its zero again</source>
            <translation>a posição da máquina é desconhecida: veja se o spindle e as saídas estão desligados, depois referencie ou defina o zero de novo</translation>
        </message>
        <message>
            <source>the measured length is far from the commanded one</source>
            <translation>o comprimento medido está longe do comandado</translation>
        </message>
        <message>
            <source>the memory card cannot be mounted</source>
            <translation>o cartão de memória não pode ser montado</translation>
        </message>
        <message>
            <source>the mill does not cut over its centre: it can neither plunge nor come down beside a tab</source>
            <translation>a fresa não corta sobre o centro: não pode mergulhar nem descer ao lado de uma ponte</translation>
        </message>
        <message>
            <source>the mini-lathe's controller</source>
            <translation>o controlador do minitorno</translation>
        </message>
        <message>
            <source>the minor diameter does not fit the major one and the pitch</source>
            <translation>o diâmetro menor não combina com o maior e o passo</translation>
        </message>
        <message>
            <source>the motor of {name} may lose steps: at {speed:.4g} mm/s ({rpm_at:.0f} rpm) and {acceleration:.4g} mm/s² it has too little torque</source>
            <translation>o motor de {name} pode perder passos: a {speed:.4g} mm/s ({rpm_at:.0f} rpm) e {acceleration:.4g} mm/s² falta-lhe torque</translation>
        </message>
        <message>
            <source>the mouth's</source>
            <translation>a da boca</translation>
        </message>
        <message>
            <source>the move after the end of a compensation must be a line</source>
            <translation>o movimento depois do fim de uma compensação deve ser uma reta</translation>
        </message>
        <message>
            <source>the move leaves the travel of {name} by {over:.4g} mm</source>
            <translation>o movimento sai do curso de {name} por {over:.4g} mm</translation>
        </message>
        <message>
            <source>the moves before the restart cut into the wanted part</source>
            <translation>os movimentos dados como feitos invadem a peça desejada</translation>
        </message>
        <message>
            <source>the moves before the restart leave material that should be removed</source>
            <translation>os movimentos dados como feitos deixam material que deveria ser removido</translation>
        </message>
        <message>
            <source>the name is not closed</source>
            <translation>o nome não está fechado</translation>
        </message>
        <message>
            <source>the name of a parameter holds a comment</source>
            <translation>o nome de um parâmetro contém um comentário</translation>
        </message>
        <message>
            <source>the nose is too large for a hollow of the profile</source>
            <translation>a ponta é grande demais para uma concavidade do perfil</translation>
        </message>
        <message>
            <source>the nose leaves a fillet of {nose:g} mm in {count:g} inner corners</source>
            <translation>a ponta deixa um arredondamento de {nose:g} mm em {count:g} cantos internos</translation>
        </message>
        <message>
            <source>the number of a subprogram</source>
            <translation>o número de um subprograma</translation>
        </message>
        <message>
            <source>the number of turns is a whole number from 1</source>
            <translation>o número de voltas é um inteiro a partir de 1</translation>
        </message>
        <message>
            <source>the numbers of an arc are damaged</source>
            <translation>os números de um arco estão danificados</translation>
        </message>
        <message>
            <source>the numbers of {0} are damaged</source>
            <translation>os números de {0} estão danificados</translation>
        </message>
        <message>
            <source>the object of this program is no longer there</source>
            <translation>o objeto deste programa não existe mais</translation>
        </message>
        <message>
            <source>the operation has no feed</source>
            <translation>a operação não tem avanço</translation>
        </message>
        <message>
            <source>the operation is too long for one program</source>
            <translation>a operação é longa demais para um programa</translation>
        </message>
        <message>
            <source>the order has no rows, or too many</source>
            <translation>o pedido não tem linhas, ou tem demais</translation>
        </message>
        <message>
            <source>the order is no CSV: {error}</source>
            <translation>o pedido não é CSV: {error}</translation>
        </message>
        <message>
            <source>the order is no UTF-8 text</source>
            <translation>o pedido não é texto em UTF-8</translation>
        </message>
        <message>
            <source>the other end has closed it</source>
            <translation>a outra ponta a fechou</translation>
        </message>
        <message>
            <source>the outer diameter</source>
            <translation>o diâmetro externo</translation>
        </message>
        <message>
            <source>the outlines are beside the stock</source>
            <translation>os contornos ficam ao lado do bloco</translation>
        </message>
        <message>
            <source>the outlines enclose nothing</source>
            <translation>os contornos não encerram nada</translation>
        </message>
        <message>
            <source>the outlines, less islands and stock to leave, leave nothing to cut</source>
            <translation>os contornos, menos as ilhas e o sobremetal, não deixam nada a cortar</translation>
        </message>
        <message>
            <source>the overcut is longer than the contour</source>
            <translation>o sobrecorte é mais longo que o contorno</translation>
        </message>
        <message>
            <source>the overlap is only {here_mm:.3g} mm: the cut begins there</source>
            <translation>a sobreposição é de apenas {here_mm:.3g} mm: o corte começa ali</translation>
        </message>
        <message>
            <source>the overrides differ from those before the reset</source>
            <translation>os ajustes de velocidade não são os de antes do reinício</translation>
        </message>
        <message>
            <source>the packing of a strip</source>
            <translation>o empacotamento de uma faixa</translation>
        </message>
        <message>
            <source>the parallel port's controller</source>
            <translation>o controlador da porta paralela</translation>
        </message>
        <message>
            <source>the parameters of the file are not in the order of their numbers</source>
            <translation>os parâmetros do arquivo não estão na ordem de seus números</translation>
        </message>
        <message>
            <source>the part at X{x:.3f} Y{y:.3f} would come loose before it is cut, in any order</source>
            <translation>o que fica em X{x:.3f} Y{y:.3f} se soltaria antes de ser cortado, em qualquer ordem</translation>
        </message>
        <message>
            <source>the part may differ from it by as much: lower P, or follow the exact path with G61</source>
            <translation>a peça pode diferir dele por esse tanto: diminua P, ou siga o caminho exato com G61</translation>
        </message>
        <message>
            <source>the path begins at the machine's position: it has incremental moves (G91) only</source>
            <translation>o percurso começa onde a máquina estiver: ele é dado só por distâncias (G91)</translation>
        </message>
        <message>
            <source>the path contains the tool's radius and is right for this tool only</source>
            <translation>o raio da ferramenta entrou no percurso, que só vale para esta ferramenta</translation>
        </message>
        <message>
            <source>the path is entered above the height that is given</source>
            <translation>o percurso é retomado acima da altura informada</translation>
        </message>
        <message>
            <source>the path mode may not be changed</source>
            <translation>o modo de percurso não pode ser mudado</translation>
        </message>
        <message>
            <source>the pattern cannot be read: {error}</source>
            <translation>o padrão de busca não pode ser lido: {error}</translation>
        </message>
        <message>
            <source>the picture has no dark areas</source>
            <translation>a imagem não tem áreas escuras</translation>
        </message>
        <message>
            <source>the picture has no size: {dpi:g} dpi are assumed; give its width</source>
            <translation>a imagem não diz o seu tamanho: tomam-se {dpi:g} dpi; dê a largura</translation>
        </message>
        <message>
            <source>the picture has too many contours</source>
            <translation>a imagem tem contornos demais</translation>
        </message>
        <message>
            <source>the picture has too many pixels</source>
            <translation>a imagem tem pixels demais</translation>
        </message>
        <message>
            <source>the piece that is cut came free at line {line}: it has fallen or moved</source>
            <translation>a peça que é cortada se soltou na linha {line}: ela caiu ou se moveu</translation>
        </message>
        <message>
            <source>the pierce delay is not the chart's</source>
            <translation>o tempo de perfuração não é o da tabela</translation>
        </message>
        <message>
            <source>the pierce height is not the cut chart's</source>
            <translation>a altura de perfuração não é a da tabela de corte</translation>
        </message>
        <message>
            <source>the pierce heights make no sense in {units}: the file seems to be in {other}</source>
            <translation>as alturas de perfuração não fazem sentido em {units}: o arquivo parece estar em {other}</translation>
        </message>
        <message>
            <source>the pierce is nearer to a part than the chart's lead-in is long: its spatter reaches the part</source>
            <translation>a perfuração está mais perto de uma peça do que o comprimento de entrada da tabela: os respingos alcançam a peça</translation>
        </message>
        <message>
            <source>the pierce lies on a part</source>
            <translation>a perfuração fica sobre uma peça</translation>
        </message>
        <message>
            <source>the pierce lies on an edge that is cut already</source>
            <translation>a perfuração fica sobre uma borda já cortada</translation>
        </message>
        <message>
            <source>the pins of the machine are not known to this reader</source>
            <translation>este leitor não conhece os pinos da máquina</translation>
        </message>
        <message>
            <source>the pitch of '{designation}' is too coarse for its diameter</source>
            <translation>o passo de '{designation}' é grosso demais para o diâmetro</translation>
        </message>
        <message>
            <source>the place cannot be written: {error}</source>
            <translation>não é possível gravar nesse local: {error}</translation>
        </message>
        <message>
            <source>the place of a restart is a line, an operation, a contour or a point</source>
            <translation>o ponto de retomada é uma linha, uma operação, um contorno ou um ponto</translation>
        </message>
        <message>
            <source>the plane may not be changed</source>
            <translation>o plano não pode ser mudado</translation>
        </message>
        <message>
            <source>the pocket is so narrow that its way at this engagement would be too long beside parallels</source>
            <translation>o bolsão é tão estreito que seu caminho com este engajamento seria longo demais em relação às paralelas</translation>
        </message>
        <message>
            <source>the pocket is too narrow for a {entry}</source>
            <translation>o bolsão é estreito demais para uma {entry}</translation>
        </message>
        <message>
            <source>the pocket is too narrow for its engagement to be bounded</source>
            <translation>o bolsão é estreito demais para que o seu engajamento seja limitado</translation>
        </message>
        <message>
            <source>the points of a freehand line lie at different heights</source>
            <translation>os pontos de uma linha à mão livre estão em alturas diferentes</translation>
        </message>
        <message>
            <source>the port is opened 8N1: neither a socket nor a pseudo-terminal has parity (the lathe itself wants 8E1)</source>
            <translation>a porta é aberta em 8N1: nem um socket nem um pseudoterminal tem paridade (o torno em si quer 8E1)</translation>
        </message>
        <message>
            <source>the port {name} is lost: {error}</source>
            <translation>a porta {name} foi perdida: {error}</translation>
        </message>
        <message>
            <source>the position along {axis} is not known here</source>
            <translation>a posição em {axis} não é conhecida aqui</translation>
        </message>
        <message>
            <source>the position along {name} is not known here</source>
            <translation>a posição em {name} não é conhecida aqui</translation>
        </message>
        <message>
            <source>the position stored for {code} is not known</source>
            <translation>a posição guardada para {code} não é conhecida</translation>
        </message>
        <message>
            <source>the power is on at the pierce for much longer than the chart's delay</source>
            <translation>a potência fica parada na perfuração muito mais do que o tempo da tabela</translation>
        </message>
        <message>
            <source>the probe is at its target already</source>
            <translation>o apalpador já está no ponto final</translation>
        </message>
        <message>
            <source>the probe touched nothing</source>
            <translation>o apalpador não tocou em nada</translation>
        </message>
        <message>
            <source>the probe touched something where nothing was to be touched</source>
            <translation>o apalpador tocou em algo onde nada devia ser tocado</translation>
        </message>
        <message>
            <source>the probe was not in its start state</source>
            <translation>o apalpador não estava no estado inicial</translation>
        </message>
        <message>
            <source>the process of this task ended each time</source>
            <translation>o processo desta tarefa terminou todas as vezes</translation>
        </message>
        <message>
            <source>the process that calculates the retract has ended</source>
            <translation>o processo que acha o caminho de volta terminou</translation>
        </message>
        <message>
            <source>the process that cuts ended before it had an answer</source>
            <translation>o processo que calcula o corte terminou antes de responder</translation>
        </message>
        <message>
            <source>the process that plays the pulses has ended; steps may be lost</source>
            <translation>o processo que envia os pulsos terminou; passos podem ter sido perdidos</translation>
        </message>
        <message>
            <source>the process that plays the pulses was stopped or got no processor time; all outputs are off, and steps may be lost</source>
            <translation>o processo que emite os pulsos ficou parado: foi suspenso, ou o computador não lhe deu tempo; tudo está desligado, e passos podem ter se perdido</translation>
        </message>
        <message>
            <source>the process that proves the program ended without an answer</source>
            <translation>o processo que verifica o programa terminou sem resposta</translation>
        </message>
        <message>
            <source>the process that reads drawings has ended</source>
            <translation>o processo que lê desenhos terminou</translation>
        </message>
        <message>
            <source>the process that reads the last job has ended</source>
            <translation>o processo que lê o último trabalho terminou</translation>
        </message>
        <message>
            <source>the process that reads the program has ended</source>
            <translation>o processo que lê o programa terminou</translation>
        </message>
        <message>
            <source>the profile begins behind the stock's end</source>
            <translation>o perfil começa atrás da ponta do material</translation>
        </message>
        <message>
            <source>the profile cannot be reached from where the cycle begins</source>
            <translation>o perfil não pode ser alcançado de onde o ciclo começa</translation>
        </message>
        <message>
            <source>the profile crosses itself</source>
            <translation>o perfil cruza a si mesmo</translation>
        </message>
        <message>
            <source>the profile goes over the centre</source>
            <translation>o perfil passa do centro</translation>
        </message>
        <message>
            <source>the profile has an undercut: it runs back towards the end face</source>
            <translation>o perfil tem um rebaixo: ele volta em direção à face</translation>
        </message>
        <message>
            <source>the profile has no end</source>
            <translation>o perfil não tem fim</translation>
        </message>
        <message>
            <source>the profile has no key {key}</source>
            <translation>o perfil não tem a chave {key}</translation>
        </message>
        <message>
            <source>the profile is smaller than its allowance</source>
            <translation>o perfil é menor que o seu sobremetal</translation>
        </message>
        <message>
            <source>the profile turns back along Z</source>
            <translation>o perfil volta para trás em Z</translation>
        </message>
        <message>
            <source>the program before it</source>
            <translation>o programa anterior</translation>
        </message>
        <message>
            <source>the program begins at X{x:g} Y{y:g}, which is over the sheet: move the wire out of the sheet, to X{begin_x:.3f} Y{begin_y:.3f}, before it is started</source>
            <translation>o programa começa em X{x:g} Y{y:g}, que fica sobre a chapa: leve o fio para fora da chapa, até X{begin_x:.3f} Y{begin_y:.3f}, antes de iniciá-lo</translation>
        </message>
        <message>
            <source>the program begins with the tool at the work zero: bring it there before this one is sent</source>
            <translation>o programa começa com a ferramenta no zero da peça: leve-a até lá antes de enviar este</translation>
        </message>
        <message>
            <source>the program cannot be written: {error}</source>
            <translation>o programa não pode ser gravado: {error}</translation>
        </message>
        <message>
            <source>the program cannot run from here on its own: {error}</source>
            <translation>retomado aqui, o programa não se sustenta sozinho: {error}</translation>
        </message>
        <message>
            <source>the program changes no tool</source>
            <translation>o programa não troca de ferramenta</translation>
        </message>
        <message>
            <source>the program cuts along no way at one height</source>
            <translation>o programa não tem corte em altura constante</translation>
        </message>
        <message>
            <source>the program cuts nothing</source>
            <translation>o programa não corta nada</translation>
        </message>
        <message>
            <source>the program cuts nothing at a known place</source>
            <translation>o programa não corta nada em um lugar conhecido</translation>
        </message>
        <message>
            <source>the program does not contain the values of the material that QtPlasmaC has selected</source>
            <translation>o que diz o material escolhido pelo QtPlasmaC não está no texto</translation>
        </message>
        <message>
            <source>the program has no F word</source>
            <translation>o programa não tem palavra F</translation>
        </message>
        <message>
            <source>the program has no end</source>
            <translation>o programa não tem fim</translation>
        </message>
        <message>
            <source>the program has no line to send</source>
            <translation>o programa não tem linha a enviar</translation>
        </message>
        <message>
            <source>the program has too many labels</source>
            <translation>o programa tem rótulos demais</translation>
        </message>
        <message>
            <source>the program has too many lines for these numbers</source>
            <translation>o programa tem linhas demais para estes números</translation>
        </message>
        <message>
            <source>the program has too many parameters</source>
            <translation>o programa tem parâmetros demais</translation>
        </message>
        <message>
            <source>the program has {place}, which goes by the machine's own zero</source>
            <translation>o programa tem {place}, que parte do zero próprio da máquina</translation>
        </message>
        <message>
            <source>the program holds no feed that is seen from above</source>
            <translation>o programa não tem nenhum avanço visível de cima</translation>
        </message>
        <message>
            <source>the program is larger than the travel of {name}</source>
            <translation>o programa é maior que o curso de {name}</translation>
        </message>
        <message>
            <source>the program is none of the job's parts</source>
            <translation>o programa não é nenhuma das partes do trabalho</translation>
        </message>
        <message>
            <source>the program is not the one that was proven: its text differs</source>
            <translation>o programa não é o que foi verificado: o texto é outro</translation>
        </message>
        <message>
            <source>the program is read as {dialect}</source>
            <translation>o programa é lido como {dialect}</translation>
        </message>
        <message>
            <source>the program is too long for it to be known which pieces fall</source>
            <translation>o programa é longo demais para se saber quais peças caem</translation>
        </message>
        <message>
            <source>the program moves nothing</source>
            <translation>o programa não move nada</translation>
        </message>
        <message>
            <source>the program needs more than one tool</source>
            <translation>o programa precisa de mais de uma ferramenta</translation>
        </message>
        <message>
            <source>the program pauses while the spindle turns</source>
            <translation>o programa espera com o spindle girando</translation>
        </message>
        <message>
            <source>the program pauses with the power on</source>
            <translation>o programa faz pausa com a potência ligada</translation>
        </message>
        <message>
            <source>the program runs on and on: is there a loop without an end?</source>
            <translation>o programa não para de executar: há um laço sem fim?</translation>
        </message>
        <message>
            <source>the program sets its own work zero (G10)</source>
            <translation>o programa define seu próprio zero da peça (G10)</translation>
        </message>
        <message>
            <source>the program that reads the solid ended without an answer (status {status})</source>
            <translation>o programa que lê o sólido terminou sem resposta (status {status})</translation>
        </message>
        <message>
            <source>the program waits with the power on in the middle of a cut</source>
            <translation>o programa espera com a potência ligada no meio de um corte</translation>
        </message>
        <message>
            <source>the program was proven for another machine, or its profile was changed since</source>
            <translation>o programa foi verificado para outra máquina, ou o perfil dela mudou desde então</translation>
        </message>
        <message>
            <source>the program was proven for another process, material, thickness or consumable</source>
            <translation>o programa foi provado para outro processo, material, espessura ou consumível</translation>
        </message>
        <message>
            <source>the program was proven from another start state: work zero, offsets or tool lengths differ</source>
            <translation>o programa foi verificado a partir de outro estado inicial: zero-peça, deslocamentos ou comprimentos de ferramenta diferem</translation>
        </message>
        <message>
            <source>the program was proven with another stock</source>
            <translation>o programa foi verificado com outro bloco</translation>
        </message>
        <message>
            <source>the program was proven with other clamps, or another distance from the sheet's edge</source>
            <translation>o programa foi verificado com outros grampos, ou com outra distância da borda da chapa</translation>
        </message>
        <message>
            <source>the program was proven with other tools</source>
            <translation>o programa foi verificado com outras ferramentas</translation>
        </message>
        <message>
            <source>the program was read as {dialect}, which no controller understands that lines are sent to</source>
            <translation>o programa foi lido como {dialect}, que nenhum controlador ao qual se enviam linhas entende</translation>
        </message>
        <message>
            <source>the program was read as {dialect}: to {firmware} its lines may mean other moves, or nothing</source>
            <translation>o programa foi lido como {dialect}: para {firmware} suas linhas podem significar outros movimentos, ou nada</translation>
        </message>
        <message>
            <source>the program's file cannot be read any more: {why}</source>
            <translation>não é mais possível ler o arquivo do programa: {why}</translation>
        </message>
        <message>
            <source>the proof failed by a fault of its own: {kind}: {error}</source>
            <translation>a verificação falhou por um defeito próprio: {kind}: {error}</translation>
        </message>
        <message>
            <source>the proof found {errors} error(s) in the program, the first: {text}</source>
            <translation>a verificação encontrou {errors} erro(s) no programa, o primeiro: {text}</translation>
        </message>
        <message>
            <source>the pulses have ended</source>
            <translation>os pulsos terminaram</translation>
        </message>
        <message>
            <source>the pulses were stopped: no more of them came in time; everything is off, and steps may be lost</source>
            <translation>os pulsos foram parados: não vieram outros a tempo; tudo está desligado, e passos podem ter sido perdidos</translation>
        </message>
        <message>
            <source>the radius at the end of the arc is {at_end:.4f} mm and at its start {radius:.4f} mm</source>
            <translation>o raio no fim do arco é {at_end:.4f} mm e no início {radius:.4f} mm</translation>
        </message>
        <message>
            <source>the radius is too small to reach the end of the arc</source>
            <translation>o raio é pequeno demais para alcançar o fim do arco</translation>
        </message>
        <message>
            <source>the rapid that leads to a contour must lead to another place, and cannot be changed</source>
            <translation>o rápido que leva a um contorno deve levar a outro lugar e não pode ser alterado</translation>
        </message>
        <message>
            <source>the reading</source>
            <translation>a leitura</translation>
        </message>
        <message>
            <source>the reading of the drawing</source>
            <translation>a leitura do desenho</translation>
        </message>
        <message>
            <source>the reading of the last job</source>
            <translation>a leitura do último trabalho</translation>
        </message>
        <message>
            <source>the record does not end</source>
            <translation>o registro não termina</translation>
        </message>
        <message>
            <source>the replacement cannot be made: {error}</source>
            <translation>a substituição não pode ser feita: {error}</translation>
        </message>
        <message>
            <source>the resolution is too fine for the ellipse</source>
            <translation>a resolução é fina demais para a elipse</translation>
        </message>
        <message>
            <source>the restart goes straight down first, from Z {high}, where the machine has homed, to Z {low}</source>
            <translation>o reinício primeiro desce reto, de Z {high}, onde a máquina se referenciou, até Z {low}</translation>
        </message>
        <message>
            <source>the retract along the cut</source>
            <translation>o caminho de volta ao longo do corte</translation>
        </message>
        <message>
            <source>the retract cannot be read back: {error}</source>
            <translation>o caminho de volta não pode ser lido: {error}</translation>
        </message>
        <message>
            <source>the retract cannot be sent as it was written</source>
            <translation>o caminho ao longo do corte não pode ser enviado como foi escrito</translation>
        </message>
        <message>
            <source>the retract does not lead to that place</source>
            <translation>o caminho de volta não leva até lá</translation>
        </message>
        <message>
            <source>the retract mode may not be changed</source>
            <translation>o modo de recuo não pode ser mudado</translation>
        </message>
        <message>
            <source>the retract plane lies below the bottom of the hole</source>
            <translation>o plano de retração fica abaixo do fundo do furo</translation>
        </message>
        <message>
            <source>the rim of the {tool} tool is slow for the material</source>
            <translation>a borda da ferramenta {tool} é lenta para o material</translation>
        </message>
        <message>
            <source>the rim of the {tool} tool is too fast for the material</source>
            <translation>a borda da ferramenta {tool} é rápida demais para o material</translation>
        </message>
        <message>
            <source>the room falls into parts away from its wall</source>
            <translation>o espaço se divide em partes longe da sua parede</translation>
        </message>
        <message>
            <source>the room of the tool's centre has islands or several parts</source>
            <translation>o espaço do centro da ferramenta tem ilhas ou várias partes</translation>
        </message>
        <message>
            <source>the rotations of {name} are no list of 1 to 360</source>
            <translation>as rotações de {name} não são uma lista de 1 a 360</translation>
        </message>
        <message>
            <source>the row has more values than there are columns</source>
            <translation>a linha tem mais valores do que há colunas</translation>
        </message>
        <message>
            <source>the row leads to an unknown place along {axis}</source>
            <translation>o movimento leva a um lugar desconhecido em {axis}</translation>
        </message>
        <message>
            <source>the row names no {name}</source>
            <translation>a linha não indica {name}</translation>
        </message>
        <message>
            <source>the rows of heights differ in length</source>
            <translation>as linhas de alturas têm comprimentos diferentes</translation>
        </message>
        <message>
            <source>the rule '{name}' clears areas, but takes open chains of the drawing</source>
            <translation>a regra '{name}' limpa áreas, mas pega cadeias abertas do desenho</translation>
        </message>
        <message>
            <source>the rule gives the shapes: leave {named} out</source>
            <translation>a regra dá as formas: deixe {named} fora</translation>
        </message>
        <message>
            <source>the safety door is open</source>
            <translation>a porta de segurança está aberta</translation>
        </message>
        <message>
            <source>the safety door is open or the machine is parking ({status}): resume later</source>
            <translation>a porta de segurança está aberta ou a máquina está estacionando ({status}): retome depois</translation>
        </message>
        <message>
            <source>the safety door was opened</source>
            <translation>a porta de segurança foi aberta</translation>
        </message>
        <message>
            <source>the safety door was opened while homing</source>
            <translation>a porta de segurança foi aberta durante o referenciamento</translation>
        </message>
        <message>
            <source>the scribe is tool {number} of LinuxCNC's table, whose X and Y are its place beside the torch</source>
            <translation>o riscador é a ferramenta {number} da tabela do LinuxCNC, cujos X e Y são o seu lugar ao lado da tocha</translation>
        </message>
        <message>
            <source>the second limit switch of a double axis was not found</source>
            <translation>o segundo fim de curso de um eixo duplo não foi encontrado</translation>
        </message>
        <message>
            <source>the second limit switch of a self-squaring axis was not found</source>
            <translation>o segundo fim de curso de um eixo com autoesquadro não foi encontrado</translation>
        </message>
        <message>
            <source>the section of sheet {number} is not closed</source>
            <translation>a seção da chapa {number} não é fechada</translation>
        </message>
        <message>
            <source>the sender failed by a fault of its own</source>
            <translation>o envio falhou por um defeito próprio</translation>
        </message>
        <message>
            <source>the sender or its computer stopped suddenly; the controller may have executed the lines in its buffer</source>
            <translation>o emissor ou seu computador parou sem avisar; o controlador pode ter executado o que tinha na memória</translation>
        </message>
        <message>
            <source>the sender's process does not start</source>
            <translation>o processo de envio não inicia</translation>
        </message>
        <message>
            <source>the sender's process ended at once</source>
            <translation>o processo de envio terminou logo</translation>
        </message>
        <message>
            <source>the session does not answer</source>
            <translation>a sessão não responde</translation>
        </message>
        <message>
            <source>the session refused {text}</source>
            <translation>a sessão recusou {text}</translation>
        </message>
        <message>
            <source>the session still runs</source>
            <translation>a sessão ainda está em curso</translation>
        </message>
        <message>
            <source>the session {session_file} has ended, and its outcome cannot be read: {why}</source>
            <translation>a sessão {session_file} terminou, e o resultado não pode ser lido: {why}</translation>
        </message>
        <message>
            <source>the session {session_file} is not there, or was killed</source>
            <translation>a sessão {session_file} não existe ou foi encerrada</translation>
        </message>
        <message>
            <source>the session {session_file} runs, but its process does not answer</source>
            <translation>a sessão {session_file} está em execução, mas seu processo não responde</translation>
        </message>
        <message>
            <source>the session's log</source>
            <translation>o registro da sessão</translation>
        </message>
        <message>
            <source>the setting cannot have this value</source>
            <translation>a configuração não pode ter este valor</translation>
        </message>
        <message>
            <source>the setting could not be stored</source>
            <translation>a configuração não pôde ser gravada</translation>
        </message>
        <message>
            <source>the setting's value is out of its range</source>
            <translation>o valor da configuração está fora da faixa</translation>
        </message>
        <message>
            <source>the settings file of the machine is not known to this reader</source>
            <translation>este leitor não conhece o arquivo de configuração da máquina</translation>
        </message>
        <message>
            <source>the shaft's</source>
            <translation>a da haste</translation>
        </message>
        <message>
            <source>the shank of the {tool} tool rubs along the wall over its flutes</source>
            <translation>a haste da ferramenta {tool} atrita na parede acima da parte cortante</translation>
        </message>
        <message>
            <source>the shape '{kind}' has no dimension {key}</source>
            <translation>a forma '{kind}' não tem a dimensão {key}</translation>
        </message>
        <message>
            <source>the shape '{name}' needs one of {ways}; {told}</source>
            <translation>a forma '{name}' precisa de um de {ways}; {told}</translation>
        </message>
        <message>
            <source>the shift of G92 went into the coordinates</source>
            <translation>o deslocamento de G92 entrou nas coordenadas</translation>
        </message>
        <message>
            <source>the shorter side</source>
            <translation>o lado menor</translation>
        </message>
        <message>
            <source>the simulation's process has ended</source>
            <translation>o processo que conhece a peça em cada momento terminou</translation>
        </message>
        <message>
            <source>the slot's width</source>
            <translation>a largura do rasgo</translation>
        </message>
        <message>
            <source>the solid cannot be read: {why}</source>
            <translation>o sólido não pode ser lido: {why}</translation>
        </message>
        <message>
            <source>the solid has nothing at that height</source>
            <translation>o sólido não tem nada nessa altura</translation>
        </message>
        <message>
            <source>the solid has too many edges or triangles</source>
            <translation>o sólido tem arestas ou triângulos demais</translation>
        </message>
        <message>
            <source>the solid has too many edges there</source>
            <translation>o sólido tem arestas demais ali</translation>
        </message>
        <message>
            <source>the solid is not closed</source>
            <translation>o sólido não está fechado</translation>
        </message>
        <message>
            <source>the spindle cannot turn at this speed</source>
            <translation>o spindle não pode girar nesta rotação</translation>
        </message>
        <message>
            <source>the spindle does not follow the program</source>
            <translation>o spindle não obedece</translation>
        </message>
        <message>
            <source>the spindle does not reach its speed</source>
            <translation>o spindle não atinge a rotação</translation>
        </message>
        <message>
            <source>the spindle does not turn so fast</source>
            <translation>o fuso não gira tão rápido</translation>
        </message>
        <message>
            <source>the spindle does not turn, but the motion goes by its turns</source>
            <translation>o spindle não gira, mas o movimento depende das voltas dele</translation>
        </message>
        <message>
            <source>the spindle is switched on at S0, since no S came before</source>
            <translation>o spindle é ligado com S0, pois nenhuma rotação foi indicada antes</translation>
        </message>
        <message>
            <source>the spindle runs while the tool is changed</source>
            <translation>o spindle gira durante a troca de ferramenta</translation>
        </message>
        <message>
            <source>the spindle speed is out of the spindle's range</source>
            <translation>a rotação está fora da faixa do spindle</translation>
        </message>
        <message>
            <source>the spindle's speed is set by hand</source>
            <translation>a rotação do spindle é ajustada à mão</translation>
        </message>
        <message>
            <source>the splines and ellipses of the drawing are too many and too wild for the tolerance</source>
            <translation>as splines e elipses do desenho são muitas e sinuosas demais para a tolerância</translation>
        </message>
        <message>
            <source>the stack has more than {0} sheets; use thicker ones</source>
            <translation>a pilha tem mais de {0} chapas; use chapas mais grossas</translation>
        </message>
        <message>
            <source>the stack has too many sheets</source>
            <translation>a pilha tem chapas demais</translation>
        </message>
        <message>
            <source>the stand-alone interpreter moves X Y Z A B C only</source>
            <translation>o interpretador autônomo só move X Y Z A B C</translation>
        </message>
        <message>
            <source>the start is in the stock: its z must be at least {face:g} mm, or its x outside {diameter:g} mm</source>
            <translation>o ponto inicial está dentro do material: seu z deve ser no mínimo {face:g} mm, ou seu x ficar fora de {diameter:g} mm</translation>
        </message>
        <message>
            <source>the state of the machine's position cannot be stored: {error}</source>
            <translation>o que se sabe da posição da máquina não pode ser guardado: {error}</translation>
        </message>
        <message>
            <source>the state of the stored settings cannot be read</source>
            <translation>o estado das configurações gravadas não pode ser lido</translation>
        </message>
        <message>
            <source>the step of the notches, in degrees,</source>
            <translation>o passo dos entalhes, em graus,</translation>
        </message>
        <message>
            <source>the step pulse is shorter than 2 microseconds</source>
            <translation>o pulso de passo é menor que 2 microssegundos</translation>
        </message>
        <message>
            <source>the step pulse is shorter than 3 microseconds</source>
            <translation>o pulso de passo é menor que 3 microssegundos</translation>
        </message>
        <message>
            <source>the step pulse is too short</source>
            <translation>o pulso de passo é curto demais</translation>
        </message>
        <message>
            <source>the stock needs three lengths above zero</source>
            <translation>o bloco precisa de três comprimentos acima de zero</translation>
        </message>
        <message>
            <source>the stored line is too long</source>
            <translation>a linha guardada é longa demais</translation>
        </message>
        <message>
            <source>the stored settings could not be read and were reset</source>
            <translation>as configurações guardadas não puderam ser lidas e foram redefinidas</translation>
        </message>
        <message>
            <source>the subroutine o&lt;{call}&gt; has no end</source>
            <translation>a sub-rotina o&lt;{call}&gt; não tem fim</translation>
        </message>
        <message>
            <source>the system has no font</source>
            <translation>o sistema não tem nenhuma fonte</translation>
        </message>
        <message>
            <source>the table gives it no diameter</source>
            <translation>a tabela não lhe dá diâmetro</translation>
        </message>
        <message>
            <source>the table has too many tools</source>
            <translation>a tabela tem ferramentas demais</translation>
        </message>
        <message>
            <source>the table of tables is damaged</source>
            <translation>o diretório de tabelas está danificado</translation>
        </message>
        <message>
            <source>the table {0} lies beyond the end of the file</source>
            <translation>a tabela {0} fica além do fim do arquivo</translation>
        </message>
        <message>
            <source>the tabs are as high as the contour is deep</source>
            <translation>as pontes são tão altas quanto o contorno é fundo</translation>
        </message>
        <message>
            <source>the target lies outside of the machine's travel</source>
            <translation>o destino fica fora do curso da máquina</translation>
        </message>
        <message>
            <source>the test leaves the travel of the axis</source>
            <translation>o teste sai do curso do eixo</translation>
        </message>
        <message>
            <source>the text</source>
            <translation>o texto</translation>
        </message>
        <message>
            <source>the text has no letter</source>
            <translation>o texto não tem nenhuma letra</translation>
        </message>
        <message>
            <source>the text is longer than the curve from its place on</source>
            <translation>o texto é mais longo que a curva a partir do seu lugar</translation>
        </message>
        <message>
            <source>the text is not found, or is the same already</source>
            <translation>o texto não foi encontrado ou já é o mesmo</translation>
        </message>
        <message>
            <source>the text is too long</source>
            <translation>o texto é longo demais</translation>
        </message>
        <message>
            <source>the thickness of material {number}</source>
            <translation>a espessura do material {number}</translation>
        </message>
        <message>
            <source>the thread '{text}' is not in the table</source>
            <translation>a rosca '{text}' não está na tabela</translation>
        </message>
        <message>
            <source>the thread is longer than its cylinder of {diameter:.4g} mm</source>
            <translation>a rosca é mais longa que o seu cilindro de {diameter:.4g} mm</translation>
        </message>
        <message>
            <source>the thread is not longer than its pull-out</source>
            <translation>a rosca não é mais longa que a sua saída</translation>
        </message>
        <message>
            <source>the thread takes too many passes</source>
            <translation>a rosca exige passadas demais</translation>
        </message>
        <message>
            <source>the timeline</source>
            <translation>a linha do tempo</translation>
        </message>
        <message>
            <source>the tolerance is negative</source>
            <translation>a tolerância é negativa</translation>
        </message>
        <message>
            <source>the tolerance is too small for this curve</source>
            <translation>a tolerância é pequena demais para esta curva</translation>
        </message>
        <message>
            <source>the tolerance must be above 0</source>
            <translation>a tolerância deve ser maior que 0</translation>
        </message>
        <message>
            <source>the tolerance must not be negative</source>
            <translation>a tolerância não pode ser negativa</translation>
        </message>
        <message>
            <source>the tool</source>
            <translation>a ferramenta</translation>
        </message>
        <message>
            <source>the tool ${tool} still runs</source>
            <translation>a ferramenta ${tool} ainda está ligada</translation>
        </message>
        <message>
            <source>the tool changer does not know which tool it holds</source>
            <translation>o trocador não sabe qual ferramenta está nele</translation>
        </message>
        <message>
            <source>the tool cuts into the wanted part</source>
            <translation>a ferramenta corta a peça desejada</translation>
        </message>
        <message>
            <source>the tool does not go into the drilled hole</source>
            <translation>a ferramenta não entra no furo</translation>
        </message>
        <message>
            <source>the tool does not reach into {corners} corners or narrow places; material left there: {told}</source>
            <translation>a ferramenta não alcança {corners} cantos ou lugares estreitos; o que fica lá: {told}</translation>
        </message>
        <message>
            <source>the tool fits nowhere along curve {number}, which begins at X{x:.3f} Y{y:.3f}</source>
            <translation>a ferramenta não cabe em lugar nenhum da curva {number}, que começa em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>the tool goes below the stock and cuts the table under it</source>
            <translation>a ferramenta passa abaixo do bloco e corta o que está embaixo</translation>
        </message>
        <message>
            <source>the tool goes up or down while it cuts: backwards it would enter at the full depth</source>
            <translation>a ferramenta sobe ou desce enquanto corta: ao contrário ela entraria na profundidade total</translation>
        </message>
        <message>
            <source>the tool is at Z {high}, and the restart first goes straight down to Z {low} as a rapid</source>
            <translation>a ferramenta está em Z {high}, e o reinício primeiro desce reto até Z {low}, em avanço rápido</translation>
        </message>
        <message>
            <source>the tool is below the stock's top while its place in X or Y is not known</source>
            <translation>a ferramenta está abaixo do topo do bloco sem que o seu lugar em X ou Y seja conhecido</translation>
        </message>
        <message>
            <source>the tool is changed by hand: write one program a tool</source>
            <translation>a ferramenta é trocada à mão: escreva um programa por ferramenta</translation>
        </message>
        <message>
            <source>the tool is compensated already</source>
            <translation>a ferramenta já está compensada</translation>
        </message>
        <message>
            <source>the tool is compensated in the planes XY and ZX only</source>
            <translation>a ferramenta só é compensada nos planos XY e ZX</translation>
        </message>
        <message>
            <source>the tool is down while it is changed</source>
            <translation>a ferramenta está embaixo durante a troca</translation>
        </message>
        <message>
            <source>the tool is not at the work zero, where a program begins: jog it there, or set the zero here</source>
            <translation>a ferramenta não está no zero de trabalho, onde um programa começa: leve-a até lá ou defina o zero aqui</translation>
        </message>
        <message>
            <source>the tool is wider than the pocket</source>
            <translation>a ferramenta é mais larga que o bolsão</translation>
        </message>
        <message>
            <source>the tool may not be changed</source>
            <translation>a ferramenta não pode ser trocada</translation>
        </message>
        <message>
            <source>the tool number is too large</source>
            <translation>o número da ferramenta é grande demais</translation>
        </message>
        <message>
            <source>the tool number is too large, or the tool table has no such tool</source>
            <translation>o número da ferramenta é grande demais, ou ela não está na tabela de ferramentas</translation>
        </message>
        <message>
            <source>the tool offset may not be changed</source>
            <translation>a correção da ferramenta não pode ser mudada</translation>
        </message>
        <message>
            <source>the tool runs into the {obstacle}</source>
            <translation>a ferramenta colide com: {obstacle}</translation>
        </message>
        <message>
            <source>the tool table cannot be read again</source>
            <translation>a tabela de ferramentas não pode ser lida de novo</translation>
        </message>
        <message>
            <source>the tool's position is unknown here</source>
            <translation>não se sabe onde a ferramenta está aqui</translation>
        </message>
        <message>
            <source>the tool's radius is compensated along this way (G41, G42)</source>
            <translation>o raio da ferramenta é compensado neste trecho (G41, G42)</translation>
        </message>
        <message>
            <source>the tool's radius is compensated: it begins at line {file_line}, with G41 or G42</source>
            <translation>o raio da ferramenta está compensado: começa na linha {file_line}, com G41 ou G42</translation>
        </message>
        <message>
            <source>the tool's width is not the cut chart's kerf</source>
            <translation>a largura da ferramenta não é a largura do corte da tabela</translation>
        </message>
        <message>
            <source>the tool's {letter} is unknown here, and a rotation needs both coordinates</source>
            <translation>a posição da ferramenta em {letter} não é conhecida aqui, e girar precisa das duas coordenadas</translation>
        </message>
        <message>
            <source>the torch cannot be switched off</source>
            <translation>a tocha não pode ser desligada</translation>
        </message>
        <message>
            <source>the triangles of the STL file are not whole</source>
            <translation>os triângulos do arquivo STL não estão completos</translation>
        </message>
        <message>
            <source>the turn of the work system went into the coordinates</source>
            <translation>a rotação do sistema de coordenadas entrou nas coordenadas</translation>
        </message>
        <message>
            <source>the value is no finite number</source>
            <translation>o valor não é um número finito</translation>
        </message>
        <message>
            <source>the value must be a whole number</source>
            <translation>o valor deve ser um número inteiro</translation>
        </message>
        <message>
            <source>the value of #{number} is known only when the program runs</source>
            <translation>o valor de #{number} só é conhecido quando o programa é executado</translation>
        </message>
        <message>
            <source>the velocity may not be reduced</source>
            <translation>a velocidade não pode ser reduzida</translation>
        </message>
        <message>
            <source>the virtual grbl ended at once</source>
            <translation>o grbl virtual terminou logo</translation>
        </message>
        <message>
            <source>the waits lie from {shortest_ms:g} to {longest_ms:g} ms, beyond {least_ms:g} to {most_ms:g}</source>
            <translation>as esperas vão de {shortest_ms:g} a {longest_ms:g} ms, fora de {least_ms:g} a {most_ms:g}</translation>
        </message>
        <message>
            <source>the wall may be up to {promise_mm:.3f} mm off: an ellipse is no offset of an ellipse, and the resolution adds to it; method "tolerance" keeps to tolerance_mm</source>
            <translation>a parede pode desviar até {promise_mm:.3f} mm: uma elipse não é paralela a outra elipse, e a resolução se soma a isso; o método "tolerance" respeita tolerance_mm</translation>
        </message>
        <message>
            <source>the web's</source>
            <translation>a da alma</translation>
        </message>
        <message>
            <source>the web's thickness</source>
            <translation>a espessura da alma</translation>
        </message>
        <message>
            <source>the width</source>
            <translation>a largura</translation>
        </message>
        <message>
            <source>the width across the flats</source>
            <translation>a largura entre faces</translation>
        </message>
        <message>
            <source>the wire begins to cut inside the sheet</source>
            <translation>o fio começa a cortar dentro da chapa</translation>
        </message>
        <message>
            <source>the wire goes through a part</source>
            <translation>o fio atravessa uma peça</translation>
        </message>
        <message>
            <source>the wire goes through the sheet without power</source>
            <translation>o fio atravessa a chapa sem potência</translation>
        </message>
        <message>
            <source>the wire has no entry into the closed hole at X{x:.3f} Y{y:.3f}</source>
            <translation>o fio não tem entrada no furo fechado em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>the wire is too thick for {corners} inner corner(s) or narrow place(s); up to {thick_mm:.3f} mm stays, most at X{x:.3f} Y{y:.3f}</source>
            <translation>o fio é grosso demais para {corners} canto(s) interno(s) ou lugar(es) estreito(s); ficam até {thick_mm:.3f} mm, o máximo em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>the wire moves before it is hot</source>
            <translation>o fio anda antes de estar quente</translation>
        </message>
        <message>
            <source>the wire would stay too long at corners and melt a hole</source>
            <translation>o fio ficaria tempo demais parado nos cantos e derreteria um buraco</translation>
        </message>
        <message>
            <source>the word {letter} has no number that can be read</source>
            <translation>a palavra {letter} não tem um número que possa ser lido</translation>
        </message>
        <message>
            <source>the words of {codes} are not edited</source>
            <translation>as palavras de {codes} não são editadas</translation>
        </message>
        <message>
            <source>the work system is locked</source>
            <translation>o sistema de coordenadas está travado</translation>
        </message>
        <message>
            <source>the work systems G59.1 to G59.3 do not exist here</source>
            <translation>os sistemas de coordenadas G59.1 a G59.3 não existem aqui</translation>
        </message>
        <message>
            <source>the work zero cannot be set here: the cut behind used another one</source>
            <translation>o zero da peça não pode ser definido aqui: o que ficou para trás foi cortado a partir de outro</translation>
        </message>
        <message>
            <source>the work zero changed while the program ran, and not by the program</source>
            <translation>o zero da peça mudou durante a execução do programa, e não pelo programa</translation>
        </message>
        <message>
            <source>the work zero is not confirmed</source>
            <translation>ninguém confirmou o zero-peça</translation>
        </message>
        <message>
            <source>the work zero is not known, so the program's place on the table is unknown</source>
            <translation>o zero-peça não é conhecido, por isso o lugar do programa na mesa é desconhecido</translation>
        </message>
        <message>
            <source>the work zero was set at a pause, so that the retract along the cut is unknown</source>
            <translation>o zero da peça foi definido numa pausa, portanto o caminho de volta ao longo do corte não é conhecido</translation>
        </message>
        <message>
            <source>the worker has CNCStepper {version}</source>
            <translation>o processo de trabalho tem o CNCStepper {version}</translation>
        </message>
        <message>
            <source>the zero of the lathe can be set in manual mode only: {0}</source>
            <translation>o zero do torno só pode ser definido em modo manual: {0}</translation>
        </message>
        <message>
            <source>the {tool_shape} tool's form is not given, so it is judged as a flat one of its diameter</source>
            <translation>a forma da ferramenta {tool_shape} não foi informada, por isso é avaliada como fresa reta do mesmo diâmetro</translation>
        </message>
        <message>
            <source>the {tool} takes too thick a chip</source>
            <translation>a ferramenta {tool} tira um cavaco grosso demais</translation>
        </message>
        <message>
            <source>the {tool} tool cuts deeper than its flutes are long</source>
            <translation>a ferramenta {tool} corta mais fundo que o seu comprimento de corte</translation>
        </message>
        <message>
            <source>the {tool} tool does not cut over its centre: it must not go straight down into full material</source>
            <translation>a ferramenta {tool} não corta sobre o centro: não pode descer reto em material cheio</translation>
        </message>
        <message>
            <source>the {tool} tool has no number of flutes; its feed is calculated with {usual_flutes}</source>
            <translation>a ferramenta {tool} não diz quantos dentes tem; o avanço é calculado com {usual_flutes}</translation>
        </message>
        <message>
            <source>the {tool} tool is too small against its path for its engagement to be measured</source>
            <translation>a ferramenta {tool} é pequena demais diante da trajetória para se medir o seu ângulo de contato</translation>
        </message>
        <message>
            <source>the {tool} tool rubs: a tooth takes too thin a chip</source>
            <translation>a ferramenta {tool} atrita em vez de cortar: um dente tira um cavaco fino demais</translation>
        </message>
        <message>
            <source>their distance</source>
            <translation>a distância entre eles</translation>
        </message>
        <message>
            <source>then runs {own} lines of the program unchanged; everything before them counts as cut</source>
            <translation>depois executa {own} linhas do programa como estão; tudo antes delas é dado como cortado</translation>
        </message>
        <message>
            <source>there are A to Z for pulses and {0} for devices</source>
            <translation>há de A a Z para pulsos e {0} para dispositivos</translation>
        </message>
        <message>
            <source>there are no relays</source>
            <translation>não há relés</translation>
        </message>
        <message>
            <source>there are {count} lines, none at {index}</source>
            <translation>há {count} linhas, nenhuma em {index}</translation>
        </message>
        <message>
            <source>there are: {axes}</source>
            <translation>há: {axes}</translation>
        </message>
        <message>
            <source>there are: {keys}</source>
            <translation>há: {keys}</translation>
        </message>
        <message>
            <source>there are: {names}</source>
            <translation>há: {names}</translation>
        </message>
        <message>
            <source>there is a machine profile '{name}' already</source>
            <translation>já há um perfil de máquina '{name}'</translation>
        </message>
        <message>
            <source>there is no act '{act}'</source>
            <translation>não existe a ação '{act}'</translation>
        </message>
        <message>
            <source>there is no command '{name}'</source>
            <translation>não há comando '{name}'</translation>
        </message>
        <message>
            <source>there is no contour {number}</source>
            <translation>não existe o contorno {number}</translation>
        </message>
        <message>
            <source>there is no cycle '{cycle}'</source>
            <translation>não há ciclo '{cycle}'</translation>
        </message>
        <message>
            <source>there is no cycle '{told}'</source>
            <translation>não há ciclo '{told}'</translation>
        </message>
        <message>
            <source>there is no dialect '{base}'</source>
            <translation>não há dialeto '{base}'</translation>
        </message>
        <message>
            <source>there is no font '{family}'</source>
            <translation>não há nenhuma fonte '{family}'</translation>
        </message>
        <message>
            <source>there is no function {name}</source>
            <translation>não há função {name}</translation>
        </message>
        <message>
            <source>there is no hole into which the boring bar gets</source>
            <translation>não há furo em que a barra de mandrilar entre</translation>
        </message>
        <message>
            <source>there is no key {key}</source>
            <translation>não há chave {key}</translation>
        </message>
        <message>
            <source>there is no machine profile '{name_or_path}'</source>
            <translation>não há perfil de máquina '{name_or_path}'</translation>
        </message>
        <message>
            <source>there is no material '{material}'; use one of: {material_names}</source>
            <translation>não há material '{material}'; use um destes: {material_names}</translation>
        </message>
        <message>
            <source>there is no material '{name}'</source>
            <translation>não há material '{name}'</translation>
        </message>
        <message>
            <source>there is no motion that the coordinates could belong to</source>
            <translation>não há movimento ao qual as coordenadas possam pertencer</translation>
        </message>
        <message>
            <source>there is no outline and no stock to face</source>
            <translation>não há contorno nem bloco a facear</translation>
        </message>
        <message>
            <source>there is no override {kind} {step}</source>
            <translation>não há ajuste {kind} {step}</translation>
        </message>
        <message>
            <source>there is no parameter #{number}</source>
            <translation>não há parâmetro #{number}</translation>
        </message>
        <message>
            <source>there is no part to draw</source>
            <translation>não há peça a desenhar</translation>
        </message>
        <message>
            <source>there is no port {name}</source>
            <translation>não há porta {name}</translation>
        </message>
        <message>
            <source>there is no process '{name}'</source>
            <translation>não existe o processo '{name}'</translation>
        </message>
        <message>
            <source>there is no program to arrange</source>
            <translation>não há nenhum programa para dispor</translation>
        </message>
        <message>
            <source>there is no relay {0}; there are {1}</source>
            <translation>não há relé {0}; há {1}</translation>
        </message>
        <message>
            <source>there is no room for a helix or ramp, and the tool does not cut over its centre</source>
            <translation>não há espaço para hélice ou rampa, e a ferramenta não corta sobre o centro</translation>
        </message>
        <message>
            <source>there is no room for a {entry} at {others} of {kinds} places</source>
            <translation>não há espaço para: {entry} em {others} de {kinds} lugares</translation>
        </message>
        <message>
            <source>there is no room for the pulses' memory: {error}</source>
            <translation>não há espaço para a memória dos pulsos: {error}</translation>
        </message>
        <message>
            <source>there is no scrap for the pierce and lead-in of {chain} near X{x:.3f} Y{y:.3f}</source>
            <translation>não há retalho para a perfuração e a entrada de {chain} perto de X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>there is no scrap for the pierce behind a tab of {chain} near X{x:.3f} Y{y:.3f}</source>
            <translation>não há retalho para a perfuração depois de uma ponte de {chain} perto de X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>there is no single-line font '{name}'</source>
            <translation>não há nenhuma fonte de linha única '{name}'</translation>
        </message>
        <message>
            <source>there is no subroutine o&lt;{seeking}&gt;</source>
            <translation>não há sub-rotina o&lt;{seeking}&gt;</translation>
        </message>
        <message>
            <source>there is no such file</source>
            <translation>não existe tal arquivo</translation>
        </message>
        <message>
            <source>there is no such font file</source>
            <translation>esse arquivo de fonte não existe</translation>
        </message>
        <message>
            <source>there is no such part of the program</source>
            <translation>não há essa parte do programa</translation>
        </message>
        <message>
            <source>there is no such verb</source>
            <translation>não existe esse verbo</translation>
        </message>
        <message>
            <source>there is no {name} of that name</source>
            <translation>não há {name} com esse nome</translation>
        </message>
        <message>
            <source>there is nothing to find</source>
            <translation>não há nada a procurar</translation>
        </message>
        <message>
            <source>there is nothing to resume</source>
            <translation>não há o que retomar</translation>
        </message>
        <message>
            <source>there is nothing to resume: the machine is not held</source>
            <translation>não há o que retomar: a máquina não está em pausa</translation>
        </message>
        <message>
            <source>there is nothing to stop</source>
            <translation>não há o que parar</translation>
        </message>
        <message>
            <source>there is nothing to unlock</source>
            <translation>não há o que destravar</translation>
        </message>
        <message>
            <source>there was nothing to read</source>
            <translation>não havia nada para ler</translation>
        </message>
        <message>
            <source>these diagonals belong to no rectangle of these sides</source>
            <translation>estas diagonais não são de um retângulo com estes lados</translation>
        </message>
        <message>
            <source>this answer belongs to an earlier pause</source>
            <translation>a parada à qual isto responde já terminou</translation>
        </message>
        <message>
            <source>this build of the controller has no such setting</source>
            <translation>esta versão do controlador não tem essa configuração</translation>
        </message>
        <message>
            <source>this client is detached</source>
            <translation>este cliente está desligado</translation>
        </message>
        <message>
            <source>this comment would run Python on the machine</source>
            <translation>este comentário executaria Python na máquina</translation>
        </message>
        <message>
            <source>this computer cannot keep the pulse rate of this program</source>
            <translation>este computador não consegue manter a taxa de pulsos deste programa</translation>
        </message>
        <message>
            <source>this computer cannot keep the rate</source>
            <translation>este computador não sustenta a taxa</translation>
        </message>
        <message>
            <source>this computer cannot keep the rate of the program's pulses</source>
            <translation>este computador não consegue manter a frequência dos pulsos do programa</translation>
        </message>
        <message>
            <source>this computer may fall asleep while the machine cuts ({why}): switch its sleep off</source>
            <translation>este computador pode adormecer enquanto a máquina corta ({why}): desligue a suspensão</translation>
        </message>
        <message>
            <source>this is a fault of this program: report it</source>
            <translation>isto é uma falha deste programa: relate-a</translation>
        </message>
        <message>
            <source>this is no Python script</source>
            <translation>isto não é um script Python</translation>
        </message>
        <message>
            <source>this is no address of a scheduler</source>
            <translation>isto não é o endereço de um escalonador</translation>
        </message>
        <message>
            <source>this is no certificate</source>
            <translation>isto não é um certificado</translation>
        </message>
        <message>
            <source>this is no input of a machine: {error}</source>
            <translation>isto não é uma entrada de máquina: {error}</translation>
        </message>
        <message>
            <source>this is no pulse letter</source>
            <translation>isto não é uma letra de pulso</translation>
        </message>
        <message>
            <source>this is no word that can be edited</source>
            <translation>o que está aqui não é uma palavra que possa ser editada</translation>
        </message>
        <message>
            <source>this is not allowed while an emergency stop or a limit is active</source>
            <translation>isto não é permitido com parada de emergência ou fim de curso ativo</translation>
        </message>
        <message>
            <source>this is switched off in the controller's configuration</source>
            <translation>isto está desligado na configuração do controlador</translation>
        </message>
        <message>
            <source>this is {kind}, not a file</source>
            <translation>isto é {kind}, não um arquivo</translation>
        </message>
        <message>
            <source>this language is in millimetres</source>
            <translation>esta linguagem é em milímetros</translation>
        </message>
        <message>
            <source>this lathe moves in straight lines: write the arc as lines</source>
            <translation>este torno se move em retas: escreva o arco como retas</translation>
        </message>
        <message>
            <source>this line is executed in modes that differ from one time to the next</source>
            <translation>esta linha é executada em modos que mudam de uma vez para outra</translation>
        </message>
        <message>
            <source>this line is in the part that is to be reversed, and is not only a move</source>
            <translation>esta linha fica em um trecho a ser percorrido ao contrário e faz mais que mover</translation>
        </message>
        <message>
            <source>this line is not executed (deleted, after the end, or never reached), so that its meaning is unknown</source>
            <translation>esta linha não é executada (bloco opcional, depois do fim ou nunca alcançada): não se sabe o que significa</translation>
        </message>
        <message>
            <source>this machine cannot be held while its program runs: its link has no such command</source>
            <translation>esta máquina não pode ser retida enquanto seu programa corre: sua ligação não aceita esse comando</translation>
        </message>
        <message>
            <source>this machine cannot be jogged from here</source>
            <translation>esta máquina não pode ser movida à mão daqui</translation>
        </message>
        <message>
            <source>this machine cannot be jogged while a program is held</source>
            <translation>esta máquina não pode ser movida à mão enquanto um programa está retido</translation>
        </message>
        <message>
            <source>this machine cannot be resumed over its link</source>
            <translation>esta máquina não pode ser retomada por sua ligação</translation>
        </message>
        <message>
            <source>this machine cannot be stopped while it runs the lines that it has</source>
            <translation>esta máquina não pode ser parada enquanto executa o que recebeu</translation>
        </message>
        <message>
            <source>this machine cannot do this: {word}</source>
            <translation>esta máquina não pode fazer isto: {word}</translation>
        </message>
        <message>
            <source>this machine cannot find its own zero</source>
            <translation>esta máquina não pode achar seu próprio zero</translation>
        </message>
        <message>
            <source>this machine cannot go back along its cut</source>
            <translation>esta máquina não pode voltar ao longo de seu corte</translation>
        </message>
        <message>
            <source>this machine does not report its position: it is calculated from the lines sent</source>
            <translation>esta máquina não informa sua posição: ela é contada pelo que foi enviado</translation>
        </message>
        <message>
            <source>this machine has no Y axis</source>
            <translation>esta máquina não tem eixo Y</translation>
        </message>
        <message>
            <source>this machine has no Z axis</source>
            <translation>esta máquina não tem eixo Z</translation>
        </message>
        <message>
            <source>this machine has no Z axis: arcs are in XY</source>
            <translation>esta máquina não tem eixo Z: os arcos ficam em XY</translation>
        </message>
        <message>
            <source>this machine has no Z axis: take it out</source>
            <translation>esta máquina não tem eixo Z: retire-o</translation>
        </message>
        <message>
            <source>this machine has no output to switch (knife and point have no power): take it out</source>
            <translation>esta máquina não tem nada que se ligue (faca e ponta não têm potência): retire-o</translation>
        </message>
        <message>
            <source>this machine has no probe</source>
            <translation>esta máquina não tem apalpador</translation>
        </message>
        <message>
            <source>this machine has no spindle whose speed is chosen: write M3 alone</source>
            <translation>esta máquina não tem fuso com rotação escolhida: escreva só M3</translation>
        </message>
        <message>
            <source>this machine has {axes}</source>
            <translation>esta máquina tem {axes}</translation>
        </message>
        <message>
            <source>this machine's speeds cannot be changed while its program runs</source>
            <translation>as velocidades desta máquina não podem ser alteradas enquanto seu programa corre</translation>
        </message>
        <message>
            <source>this material number is none of a material file</source>
            <translation>este número de material não é de um arquivo de materiais</translation>
        </message>
        <message>
            <source>this one is made when that is done, in about a minute</source>
            <translation>este será feito por si mesmo quando isso terminar, em cerca de um minuto</translation>
        </message>
        <message>
            <source>this pin of the machine is not known to this reader</source>
            <translation>este leitor não conhece este pino da máquina</translation>
        </message>
        <message>
            <source>this program does not understand the answers of the session {session_file}</source>
            <translation>a sessão {session_file} responde o que este programa não entende</translation>
        </message>
        <message>
            <source>this reader knows no pockets</source>
            <translation>este leitor não conhece posições do magazine</translation>
        </message>
        <message>
            <source>this setting can only be read</source>
            <translation>esta configuração só pode ser lida</translation>
        </message>
        <message>
            <source>this setting cannot be changed while the controller runs</source>
            <translation>esta configuração não pode mudar com o controlador em funcionamento</translation>
        </message>
        <message>
            <source>this shape has no holes</source>
            <translation>esta forma não tem furos</translation>
        </message>
        <message>
            <source>this system has no Unix sockets</source>
            <translation>este sistema não tem sockets Unix</translation>
        </message>
        <message>
            <source>this takes long and is calculated in the background</source>
            <translation>isto demora, e está sendo feito ao lado da janela</translation>
        </message>
        <message>
            <source>those of splines count {spline_weight} times</source>
            <translation>os de splines contam {spline_weight} vezes</translation>
        </message>
        <message>
            <source>threads can be cut only in the plane ZX</source>
            <translation>roscas só podem ser cortadas no plano ZX</translation>
        </message>
        <message>
            <source>three times the bar's width</source>
            <translation>três vezes a largura da barra</translation>
        </message>
        <message>
            <source>threshold {threshold}</source>
            <translation>limiar {threshold}</translation>
        </message>
        <message>
            <source>times its diameter</source>
            <translation>vezes o diâmetro</translation>
        </message>
        <message>
            <source>tiny chains</source>
            <translation>cadeias minúsculas</translation>
        </message>
        <message>
            <source>tiny chains were taken out</source>
            <translation>cadeias minúsculas foram retiradas</translation>
        </message>
        <message>
            <source>tip_diameter_mm must be below diameter_mm</source>
            <translation>tip_diameter_mm deve ser menor que diameter_mm</translation>
        </message>
        <message>
            <source>to end its process would not stop the machine</source>
            <translation>encerrar o processo não pararia a máquina</translation>
        </message>
        <message>
            <source>to turn a side round use mirror</source>
            <translation>para inverter um lado use o espelhamento</translation>
        </message>
        <message>
            <source>too many drawings, or one read in too many ways</source>
            <translation>desenhos demais, ou um lido de maneiras demais</translation>
        </message>
        <message>
            <source>too many ends of lines lie within {within_mm:g} mm of each other</source>
            <translation>extremos de linhas demais ficam a menos de {within_mm:g} mm uns dos outros</translation>
        </message>
        <message>
            <source>too many lines and arcs in its files</source>
            <translation>linhas e arcos demais nos seus arquivos</translation>
        </message>
        <message>
            <source>too many lines are on top of each other</source>
            <translation>linhas demais estão umas sobre as outras</translation>
        </message>
        <message>
            <source>too many numbers</source>
            <translation>números demais</translation>
        </message>
        <message>
            <source>too many points</source>
            <translation>pontos demais</translation>
        </message>
        <message>
            <source>tool changes by a pause</source>
            <translation>trocas de ferramenta por pausa</translation>
        </message>
        <message>
            <source>tool must be a list of tables with a number</source>
            <translation>tool tem de ser uma lista de tabelas com um número</translation>
        </message>
        <message>
            <source>tool {0}: {1} rpm</source>
            <translation>ferramenta {0}: {1} rpm</translation>
        </message>
        <message>
            <source>tool {each_number} '{each}' is left out: {notes}</source>
            <translation>a ferramenta {each_number} '{each}' fica de fora: {notes}</translation>
        </message>
        <message>
            <source>tool {number} '{name}' cannot be used: {notes}</source>
            <translation>a ferramenta {number} '{name}' não pode ser usada: {notes}</translation>
        </message>
        <message>
            <source>tool {number} '{name}': a table has no {lost}</source>
            <translation>ferramenta {number} '{name}': uma tabela não tem {lost}</translation>
        </message>
        <message>
            <source>tool {number} cuts on without a stop to change tool {number2}</source>
            <translation>a ferramenta {number} continua o corte sem parada para trocar a ferramenta {number2}</translation>
        </message>
        <message>
            <source>tool {number} has no shape: its moves are not simulated</source>
            <translation>a ferramenta {number} não tem forma: seus movimentos não são simulados</translation>
        </message>
        <message>
            <source>tool {number} is unknown, so that its cuts are not checked</source>
            <translation>a ferramenta {number} não é conhecida, por isso o que ela corta não é verificado</translation>
        </message>
        <message>
            <source>tool {stored_number} of {form_file}: {note}</source>
            <translation>ferramenta {stored_number} de {form_file}: {note}</translation>
        </message>
        <message>
            <source>tool {tool_number} has no {name}</source>
            <translation>a ferramenta {tool_number} não tem {name}</translation>
        </message>
        <message>
            <source>tool {tool} is not in the tool table</source>
            <translation>a ferramenta {tool} não está na tabela de ferramentas</translation>
        </message>
        <message>
            <source>torque must be points (rpm, Nm) that rise in rpm</source>
            <translation>torque deve ser uma lista de pontos (rpm, Nm) com rpm crescente</translation>
        </message>
        <message>
            <source>torque must not be below zero</source>
            <translation>torque não pode ser negativo</translation>
        </message>
        <message>
            <source>travel_min_mm must be below travel_max_mm</source>
            <translation>travel_min_mm deve ser menor que travel_max_mm</translation>
        </message>
        <message>
            <source>try again</source>
            <translation>tente de novo</translation>
        </message>
        <message>
            <source>try again; if it stays so, the program may need more memory than there is</source>
            <translation>tente de novo; se continuar assim, o programa talvez precise de mais memória do que há</translation>
        </message>
        <message>
            <source>try it again</source>
            <translation>tente de novo</translation>
        </message>
        <message>
            <source>turn the program instead</source>
            <translation>gire o programa em vez disso</translation>
        </message>
        <message>
            <source>turn the spindle faster</source>
            <translation>gire o spindle mais rápido</translation>
        </message>
        <message>
            <source>turn the spindle slower</source>
            <translation>gire o spindle mais devagar</translation>
        </message>
        <message>
            <source>turn with at most {most:.4g} rpm</source>
            <translation>gire no máximo a {most:.4g} rpm</translation>
        </message>
        <message>
            <source>turning (G7, G95, G96) is in force here: no entry is written for a lathe</source>
            <translation>torneamento (G7, G95, G96) está em vigor aqui: nenhuma entrada é escrita para um torno</translation>
        </message>
        <message>
            <source>turning clockwise (M3)</source>
            <translation>girando no sentido horário (M3)</translation>
        </message>
        <message>
            <source>turning counter-clockwise (M4)</source>
            <translation>girando no sentido anti-horário (M4)</translation>
        </message>
        <message>
            <source>twice the holes' distance from it</source>
            <translation>duas vezes a distância dos furos até ele</translation>
        </message>
        <message>
            <source>two arcs of the profile have one centre</source>
            <translation>dois arcos do perfil têm o mesmo centro</translation>
        </message>
        <message>
            <source>two chamfers</source>
            <translation>dois chanfros</translation>
        </message>
        <message>
            <source>two commands of one line both use axis words</source>
            <translation>dois comandos de uma linha querem palavras de eixo</translation>
        </message>
        <message>
            <source>two flanges</source>
            <translation>duas mesas</translation>
        </message>
        <message>
            <source>two holes would meet</source>
            <translation>dois furos se encontrariam</translation>
        </message>
        <message>
            <source>two legs</source>
            <translation>duas abas</translation>
        </message>
        <message>
            <source>two lines of the profile are parallel</source>
            <translation>duas retas do perfil são paralelas</translation>
        </message>
        <message>
            <source>two parts lie too close to each other for the wire to pass, at X{x:.3f} Y{y:.3f}</source>
            <translation>duas peças estão perto demais uma da outra para o fio passar, em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>two rows are for {thickness:g} mm of {material}</source>
            <translation>duas linhas são para {thickness:g} mm de {material}</translation>
        </message>
        <message>
            <source>two rules have the same title</source>
            <translation>duas regras têm o mesmo título</translation>
        </message>
        <message>
            <source>two self-squaring axes cannot be homed at the same time</source>
            <translation>dois eixos com autoesquadro não podem ser referenciados ao mesmo tempo</translation>
        </message>
        <message>
            <source>two shapes have the name '{shape}'</source>
            <translation>duas formas têm o nome '{shape}'</translation>
        </message>
        <message>
            <source>two tools have the same number</source>
            <translation>duas ferramentas têm o mesmo número</translation>
        </message>
        <message>
            <source>two words of one modal group are in one line</source>
            <translation>duas palavras do mesmo grupo modal estão em uma linha</translation>
        </message>
        <message>
            <source>two words of the line contradict each other</source>
            <translation>duas palavras da linha se contradizem</translation>
        </message>
        <message>
            <source>two {of_what} have the same {key}</source>
            <translation>dois de {of_what} têm o mesmo {key}</translation>
        </message>
        <message>
            <source>undo that, choose another drawing, or choose none</source>
            <translation>desfaça isso, escolha outro desenho, ou nenhum</translation>
        </message>
        <message>
            <source>unite them to one solid, and export it again</source>
            <translation>una-os em um só sólido e exporte-o de novo</translation>
        </message>
        <message>
            <source>unknown keys {unknown}</source>
            <translation>chaves desconhecidas {unknown}</translation>
        </message>
        <message>
            <source>unknown: {home} before the restart; {until_homed}</source>
            <translation>desconhecida: {home} antes do reinício; {until_homed}</translation>
        </message>
        <message>
            <source>unlock it ($X); where it stays locked, disconnect and connect again; then set its zero</source>
            <translation>desbloqueie-a ($X); se ela continuar bloqueada, desconecte e conecte de novo; depois defina o zero</translation>
        </message>
        <message>
            <source>unlock it in the settings, or use another work system</source>
            <translation>destrave-o nas configurações, ou use outro sistema de coordenadas</translation>
        </message>
        <message>
            <source>unlock it with $X</source>
            <translation>destrave-o com $X</translation>
        </message>
        <message>
            <source>until then nothing but homing, jogging and setting the zero is safe</source>
            <translation>até lá só é seguro referenciar, mover manualmente e definir o zero</translation>
        </message>
        <message>
            <source>up to</source>
            <translation>até</translation>
        </message>
        <message>
            <source>update its firmware</source>
            <translation>atualize o firmware</translation>
        </message>
        <message>
            <source>use #&lt;_current_tool&gt;</source>
            <translation>use #&lt;_current_tool&gt;</translation>
        </message>
        <message>
            <source>use + - * / ** MOD EQ NE GT GE LT LE AND OR XOR</source>
            <translation>use + - * / ** MOD EQ NE GT GE LT LE AND OR XOR</translation>
        </message>
        <message>
            <source>use 10 and 10</source>
            <translation>use 10 e 10</translation>
        </message>
        <message>
            <source>use G43 with the tool's number in H</source>
            <translation>use G43 com o número da ferramenta em H</translation>
        </message>
        <message>
            <source>use G43.1 with the length in Z</source>
            <translation>use G43.1 com o comprimento em Z</translation>
        </message>
        <message>
            <source>use G54 to G59</source>
            <translation>use G54 a G59</translation>
        </message>
        <message>
            <source>use G82, or leave dwell_s out</source>
            <translation>use G82 ou omita dwell_s</translation>
        </message>
        <message>
            <source>use G83 or G73, or leave peck_mm out</source>
            <translation>use G83 ou G73, ou omita peck_mm</translation>
        </message>
        <message>
            <source>use I and J instead of R</source>
            <translation>use I e J em vez de R</translation>
        </message>
        <message>
            <source>use ROUND[...]</source>
            <translation>use ROUND[...]</translation>
        </message>
        <message>
            <source>use X or Y</source>
            <translation>use X ou Y</translation>
        </message>
        <message>
            <source>use a boring bar</source>
            <translation>use uma barra de mandrilar</translation>
        </message>
        <message>
            <source>use a drill or a flat mill</source>
            <translation>use uma broca ou uma fresa de topo</translation>
        </message>
        <message>
            <source>use a flat tool</source>
            <translation>use uma fresa de topo reto</translation>
        </message>
        <message>
            <source>use a longer drill</source>
            <translation>use uma broca mais longa</translation>
        </message>
        <message>
            <source>use a longer one</source>
            <translation>use um mais longo</translation>
        </message>
        <message>
            <source>use a mill, an engraver, a jet or a wire</source>
            <translation>use uma fresa, um gravador, um jato ou um fio</translation>
        </message>
        <message>
            <source>use a mill, or lift the drill before it</source>
            <translation>use uma fresa, ou levante a broca antes disso</translation>
        </message>
        <message>
            <source>use a more pointed insert or a groove</source>
            <translation>use uma pastilha mais aguda ou um canal</translation>
        </message>
        <message>
            <source>use a name of your own</source>
            <translation>use um nome próprio</translation>
        </message>
        <message>
            <source>use a smaller kerf, or widen the web</source>
            <translation>use um corte mais estreito, ou alargue a parede</translation>
        </message>
        <message>
            <source>use a smaller nose</source>
            <translation>use uma ponta menor</translation>
        </message>
        <message>
            <source>use a smaller tool</source>
            <translation>use uma ferramenta menor</translation>
        </message>
        <message>
            <source>use a smaller tool or one that plunges</source>
            <translation>use uma ferramenta menor ou uma que mergulhe</translation>
        </message>
        <message>
            <source>use a smaller tool, a larger engagement_max_deg, or another pattern</source>
            <translation>use uma ferramenta menor, um engagement_max_deg maior ou outro padrão</translation>
        </message>
        <message>
            <source>use a smaller tool, or another contour</source>
            <translation>use uma ferramenta menor ou outro contorno</translation>
        </message>
        <message>
            <source>use a smaller tool, or round the corner off</source>
            <translation>use uma ferramenta menor ou arredonde o canto</translation>
        </message>
        <message>
            <source>use a speed between $31 and $30</source>
            <translation>use uma rotação entre $31 e $30</translation>
        </message>
        <message>
            <source>use a steady rest, or at most {length:.4g} mm</source>
            <translation>use uma luneta, ou no máximo {length:.4g} mm</translation>
        </message>
        <message>
            <source>use a tailstock, or at most {length:.4g} mm</source>
            <translation>use um contraponto, ou no máximo {length:.4g} mm</translation>
        </message>
        <message>
            <source>use a thread mill with one tooth, given as an engraver with a large tip_diameter_mm or as flat</source>
            <translation>use uma fresa de rosca de um dente, indicada como engraver com tip_diameter_mm grande ou como flat</translation>
        </message>
        <message>
            <source>use a thread mill, given as an engraver or as flat</source>
            <translation>use uma fresa de rosca, dada como gravador ou como de topo</translation>
        </message>
        <message>
            <source>use a tool number up to 255</source>
            <translation>use um número de ferramenta até 255</translation>
        </message>
        <message>
            <source>use a tool that the table has</source>
            <translation>use uma ferramenta que esteja na tabela</translation>
        </message>
        <message>
            <source>use a wire</source>
            <translation>use um fio</translation>
        </message>
        <message>
            <source>use a work offset (G54) instead</source>
            <translation>use em vez disso um sistema de coordenadas (G54)</translation>
        </message>
        <message>
            <source>use an engagement_max_deg of {deg} or more with a stepover_mm of {stepover_mm:g} or more, a smaller tool, or another pattern</source>
            <translation>use um engagement_max_deg de {deg} ou mais com um stepover_mm de {stepover_mm:g} ou mais, uma ferramenta menor ou outro padrão</translation>
        </message>
        <message>
            <source>use another blade</source>
            <translation>use outro bedame</translation>
        </message>
        <message>
            <source>use another holder</source>
            <translation>use outro suporte</translation>
        </message>
        <message>
            <source>use another insert or holder</source>
            <translation>use outra pastilha ou outro suporte</translation>
        </message>
        <message>
            <source>use another tool</source>
            <translation>use outra ferramenta</translation>
        </message>
        <message>
            <source>use entry "helix" or "ramp"</source>
            <translation>use a entrada "helix" ou "ramp"</translation>
        </message>
        <message>
            <source>use entry "plunge"</source>
            <translation>use a entrada "plunge"</translation>
        </message>
        <message>
            <source>use entry "ramp" or "plunge"</source>
            <translation>use a entrada "ramp" ou "plunge"</translation>
        </message>
        <message>
            <source>use larger steps or a smaller depth</source>
            <translation>use passos maiores ou uma profundidade menor</translation>
        </message>
        <message>
            <source>use method "tolerance" or a smaller tool</source>
            <translation>use o método "tolerance" ou uma ferramenta menor</translation>
        </message>
        <message>
            <source>use o, nu, na, {0}</source>
            <translation>use o, nu, na, {0}</translation>
        </message>
        <message>
            <source>use one of carbide</source>
            <translation>use uma de metal duro</translation>
        </message>
        <message>
            <source>use one of those that `$#` lists</source>
            <translation>use um dos que `$#` lista</translation>
        </message>
        <message>
            <source>use one of: {consumables}</source>
            <translation>use um destes: {consumables}</translation>
        </message>
        <message>
            <source>use one of: {cycles}</source>
            <translation>use um destes: {cycles}</translation>
        </message>
        <message>
            <source>use one of: {dialect_names}</source>
            <translation>use um destes: {dialect_names}</translation>
        </message>
        <message>
            <source>use one of: {keywords}</source>
            <translation>use um destes: {keywords}</translation>
        </message>
        <message>
            <source>use one of: {kinds}</source>
            <translation>use um de: {kinds}</translation>
        </message>
        <message>
            <source>use one of: {known}</source>
            <translation>use um destes: {known}</translation>
        </message>
        <message>
            <source>use one of: {material_names}</source>
            <translation>use um destes: {material_names}</translation>
        </message>
        <message>
            <source>use one of: {materials}, or give a chart of your own</source>
            <translation>use um destes: {materials}, ou dê uma tabela própria</translation>
        </message>
        <message>
            <source>use one of: {operations}</source>
            <translation>use um destes: {operations}</translation>
        </message>
        <message>
            <source>use one of: {processes}</source>
            <translation>use um destes: {processes}</translation>
        </message>
        <message>
            <source>use one of: {shapes}</source>
            <translation>use uma destas: {shapes}</translation>
        </message>
        <message>
            <source>use one of: {there}</source>
            <translation>use um destes: {there}</translation>
        </message>
        <message>
            <source>use one that `$` lists</source>
            <translation>use um dos que `$` lista</translation>
        </message>
        <message>
            <source>use one work offset</source>
            <translation>use um só sistema de coordenadas</translation>
        </message>
        <message>
            <source>use pattern "offset" or "zigzag"</source>
            <translation>use o padrão "offset" ou "zigzag"</translation>
        </message>
        <message>
            <source>use side "inside", "outside" or "on"</source>
            <translation>use o lado "inside", "outside" ou "on"</translation>
        </message>
        <message>
            <source>use the machine's own buttons</source>
            <translation>use os botões da própria máquina</translation>
        </message>
        <message>
            <source>use the version of CNCStepper that started it</source>
            <translation>use a versão do CNCStepper que a iniciou</translation>
        </message>
        <message>
            <source>use thicker sheets</source>
            <translation>use chapas mais grossas</translation>
        </message>
        <message>
            <source>use {functions} or ATAN</source>
            <translation>use {functions} ou ATAN</translation>
        </message>
        <message>
            <source>value {value}</source>
            <translation>valor {value}</translation>
        </message>
        <message>
            <source>wait a moment</source>
            <translation>espere um momento</translation>
        </message>
        <message>
            <source>wait a moment, then try again</source>
            <translation>espere um momento e tente de novo</translation>
        </message>
        <message>
            <source>wait longer, hold or stop it</source>
            <translation>espere mais, pause ou pare</translation>
        </message>
        <message>
            <source>wait until it has ended, or stop it</source>
            <translation>espere que termine, ou pare-o</translation>
        </message>
        <message>
            <source>wait until it has finished, or stop it</source>
            <translation>espere que termine, ou pare-a</translation>
        </message>
        <message>
            <source>wait until it has started</source>
            <translation>espere até que tenha iniciado</translation>
        </message>
        <message>
            <source>wait until it is at rest, or hold it</source>
            <translation>espere até que pare, ou retenha-a</translation>
        </message>
        <message>
            <source>wait until it is homed</source>
            <translation>espere até que esteja referenciada</translation>
        </message>
        <message>
            <source>wait until it is idle</source>
            <translation>espere até que esteja pronta</translation>
        </message>
        <message>
            <source>wait until it is idle; after an alarm home it or unlock it</source>
            <translation>espere até que esteja pronta; depois de um alarme, referencie ou destrave</translation>
        </message>
        <message>
            <source>wait until the jog has ended</source>
            <translation>espere o fim do movimento manual</translation>
        </message>
        <message>
            <source>wait until the program that writes it is done, then begin again</source>
            <translation>espere até que o programa que o grava termine e comece de novo</translation>
        </message>
        <message>
            <source>wait until the typed line is done, or stop it</source>
            <translation>espere o fim da linha digitada, ou pare</translation>
        </message>
        <message>
            <source>wait, hold or stop it</source>
            <translation>espere, pause ou pare</translation>
        </message>
        <message>
            <source>waits for {dwell_s:g} s</source>
            <translation>espera {dwell_s:g} s</translation>
        </message>
        <message>
            <source>waits need table_ms, or first_ms, change_ms and least_ms, or acceleration_steps_s2 and steps</source>
            <translation>as esperas precisam de table_ms, ou de first_ms, change_ms e least_ms, ou de acceleration_steps_s2 e steps</translation>
        </message>
        <message>
            <source>wake it up with a reset, then home it</source>
            <translation>acorde-a com um reset e referencie-a</translation>
        </message>
        <message>
            <source>way out</source>
            <translation>caminho de saída</translation>
        </message>
        <message>
            <source>what lies inside an outline is faced with it</source>
            <translation>o que fica dentro de um contorno é faceado com ele</translation>
        </message>
        <message>
            <source>where the machine is cannot be seen: every report of the controller is damaged</source>
            <translation>não é possível ver onde a máquina está: todos os relatórios do controlador chegam danificados</translation>
        </message>
        <message>
            <source>where the tool is when a program of {dialect} begins is not known</source>
            <translation>não se sabe onde a ferramenta está quando um programa de {dialect} começa</translation>
        </message>
        <message>
            <source>where this move began is not known, so there is no way back along it</source>
            <translation>não se sabe onde este movimento começou, portanto não há caminho de volta por ele</translation>
        </message>
        <message>
            <source>where this rapid begins is not known</source>
            <translation>não se sabe onde este rápido começa</translation>
        </message>
        <message>
            <source>where this way begins is not known</source>
            <translation>não se sabe onde este trecho começa</translation>
        </message>
        <message>
            <source>which run of line {number} is meant is not clear</source>
            <translation>não está claro qual execução da linha {number} se quer</translation>
        </message>
        <message>
            <source>while G80 is in force {dialect} takes no axis words, nor those of {user}</source>
            <translation>enquanto G80 vale, {dialect} não aceita palavras de eixo, nem as de {user}</translation>
        </message>
        <message>
            <source>width and height</source>
            <translation>largura e altura</translation>
        </message>
        <message>
            <source>with tool {tool} in the spindle</source>
            <translation>com a ferramenta {tool} no fuso</translation>
        </message>
        <message>
            <source>with {share:.0%} of its move done</source>
            <translation>com {share:.0%} do movimento já feito</translation>
        </message>
        <message>
            <source>without a file, {total} lines to send</source>
            <translation>sem arquivo, {total} linhas a enviar</translation>
        </message>
        <message>
            <source>without a lead-in the pierce lies on the cut, beside the part</source>
            <translation>sem entrada, a perfuração fica sobre o corte, ao lado da peça</translation>
        </message>
        <message>
            <source>words for the spindle</source>
            <translation>palavras para o spindle</translation>
        </message>
        <message>
            <source>words for this coolant</source>
            <translation>palavras para esta refrigeração</translation>
        </message>
        <message>
            <source>words were left over that no command uses</source>
            <translation>sobraram palavras que nenhum comando usa</translation>
        </message>
        <message>
            <source>work surface</source>
            <translation>superfície de trabalho</translation>
        </message>
        <message>
            <source>work zero</source>
            <translation>zero da peça</translation>
        </message>
        <message>
            <source>work_offset must be one of {work_systems}</source>
            <translation>work_offset deve ser um destes: {work_systems}</translation>
        </message>
        <message>
            <source>write 0 where the edge does not matter</source>
            <translation>escreva 0 onde a borda não importa</translation>
        </message>
        <message>
            <source>write ATAN[y]/[x]</source>
            <translation>escreva ATAN[y]/[x]</translation>
        </message>
        <message>
            <source>write EXISTS[#&lt;name&gt;]</source>
            <translation>escreva EXISTS[#&lt;nome&gt;]</translation>
        </message>
        <message>
            <source>write F and S above 0 before</source>
            <translation>escreva antes F e S maiores que 0</translation>
        </message>
        <message>
            <source>write F on a line of its own</source>
            <translation>escreva F em uma linha própria</translation>
        </message>
        <message>
            <source>write F{feed:.6g} into the file: its controller reads it itself, and would take an earlier feed</source>
            <translation>escreva F{feed:.6g} no arquivo: o controlador o lê sozinho e usaria um avanço anterior</translation>
        </message>
        <message>
            <source>write G0, G1, G2 or G3</source>
            <translation>escreva G0, G1, G2 ou G3</translation>
        </message>
        <message>
            <source>write G17 before</source>
            <translation>escreva G17 antes</translation>
        </message>
        <message>
            <source>write G17 before, or tap with G33.1</source>
            <translation>escreva G17 antes, ou rosqueie com G33.1</translation>
        </message>
        <message>
            <source>write G17 on a line before</source>
            <translation>escreva G17 em uma linha anterior</translation>
        </message>
        <message>
            <source>write G17 or G18 before</source>
            <translation>escreva G17 ou G18 antes</translation>
        </message>
        <message>
            <source>write G17, G18 or G19 before</source>
            <translation>escreva G17, G18 ou G19 antes</translation>
        </message>
        <message>
            <source>write G18 before</source>
            <translation>escreva G18 antes</translation>
        </message>
        <message>
            <source>write G18 before that line</source>
            <translation>escreva G18 antes dessa linha</translation>
        </message>
        <message>
            <source>write G4 P{delay_s:g} behind M3</source>
            <translation>escreva G4 P{delay_s:g} depois de M3</translation>
        </message>
        <message>
            <source>write G4 P{needed_s:g} after the spindle starts</source>
            <translation>escreva G4 P{needed_s:g} depois de ligar o spindle</translation>
        </message>
        <message>
            <source>write G40 before</source>
            <translation>escreva G40 antes</translation>
        </message>
        <message>
            <source>write G43 or G49 after the change</source>
            <translation>escreva G43 ou G49 depois da troca</translation>
        </message>
        <message>
            <source>write G5.2 before</source>
            <translation>escreva G5.2 antes</translation>
        </message>
        <message>
            <source>write G5.3 on a line before</source>
            <translation>escreva G5.3 em uma linha antes</translation>
        </message>
        <message>
            <source>write G90 (absolute) or G91 (incremental): they are the words for straight cuts</source>
            <translation>escreva G90 (absoluto) ou G91 (incremental): são as palavras para cortes retos</translation>
        </message>
        <message>
            <source>write G90 first</source>
            <translation>escreva antes G90</translation>
        </message>
        <message>
            <source>write G94 and an F word before</source>
            <translation>escreva G94 e uma palavra F antes</translation>
        </message>
        <message>
            <source>write G94 before</source>
            <translation>escreva G94 antes</translation>
        </message>
        <message>
            <source>write KEY=VALUE, for example axis.x.steps_per_mm=80</source>
            <translation>escreva CHAVE=VALOR, por exemplo axis.x.steps_per_mm=80</translation>
        </message>
        <message>
            <source>write M2 or M30 as its last line</source>
            <translation>escreva M2 ou M30 como última linha</translation>
        </message>
        <message>
            <source>write M5 ${0} before</source>
            <translation>escreva M5 ${0} antes</translation>
        </message>
        <message>
            <source>write M5 before</source>
            <translation>escreva M5 antes</translation>
        </message>
        <message>
            <source>write M5 before M0</source>
            <translation>escreva M5 antes de M0</translation>
        </message>
        <message>
            <source>write M5 before M0, and pierce again behind it</source>
            <translation>escreva M5 antes de M0, e perfure de novo depois</translation>
        </message>
        <message>
            <source>write M70 before, in the same subroutine</source>
            <translation>escreva M70 antes, na mesma sub-rotina</translation>
        </message>
        <message>
            <source>write S before</source>
            <translation>escreva S antes</translation>
        </message>
        <message>
            <source>write X and the seconds</source>
            <translation>escreva X e os segundos</translation>
        </message>
        <message>
            <source>write [MATERIAL_NUMBER_n] and below it lines such as: CUT_SPEED = 3850</source>
            <translation>escreva [MATERIAL_NUMBER_n] e abaixo linhas como: CUT_SPEED = 3850</translation>
        </message>
        <message>
            <source>write [[operation]]</source>
            <translation>escreva [[operation]]</translation>
        </message>
        <message>
            <source>write a G0 or G1 before</source>
            <translation>escreva antes um G0 ou G1</translation>
        </message>
        <message>
            <source>write a G0 with numbers before it</source>
            <translation>escreva antes dele um G0 com números</translation>
        </message>
        <message>
            <source>write a decimal number after the letter</source>
            <translation>escreva um número decimal depois da letra</translation>
        </message>
        <message>
            <source>write a finer pitch</source>
            <translation>escreva um passo mais fino</translation>
        </message>
        <message>
            <source>write a lead that is</source>
            <translation>escreva um que seja</translation>
        </message>
        <message>
            <source>write a letter</source>
            <translation>escreva uma letra</translation>
        </message>
        <message>
            <source>write a library, with the ending .fctl</source>
            <translation>escreva uma biblioteca, com a terminação .fctl</translation>
        </message>
        <message>
            <source>write a line</source>
            <translation>escreva uma reta</translation>
        </message>
        <message>
            <source>write a line G0 before it</source>
            <translation>escreva antes uma linha G0</translation>
        </message>
        <message>
            <source>write a line such as: T3 P3 D6.0 Z+41.5 ;6 mm end mill</source>
            <translation>escreva uma linha como: T3 P3 D6.0 Z+41.5 ;6 mm end mill</translation>
        </message>
        <message>
            <source>write a move with G90 before it, or move the work zero</source>
            <translation>escreva antes dele um movimento com G90 ou mova o zero-peça</translation>
        </message>
        <message>
            <source>write a number within these bounds: {why}</source>
            <translation>escreva um número dentro destes limites: {why}</translation>
        </message>
        <message>
            <source>write a number, #parameter or [expression]</source>
            <translation>escreva um número, #parâmetro ou [expressão]</translation>
        </message>
        <message>
            <source>write a point for decimals</source>
            <translation>escreva um ponto para as casas decimais</translation>
        </message>
        <message>
            <source>write a rapid to its begin</source>
            <translation>escreva um rápido até o seu início</translation>
        </message>
        <message>
            <source>write a rule for them, or one with ignore = true</source>
            <translation>escreva uma regra para elas, ou uma com ignore = true</translation>
        </message>
        <message>
            <source>write a straight line</source>
            <translation>escreva uma reta simples</translation>
        </message>
        <message>
            <source>write an F word above 0 before</source>
            <translation>escreva antes uma palavra F maior que 0</translation>
        </message>
        <message>
            <source>write an insert (CNMG120408, 16ER1.5ISO), boring:CCMT060204, parting:3 or drill:10; 2=drill:10 for tool 2</source>
            <translation>escreva uma pastilha (CNMG120408, 16ER1.5ISO), boring:CCMT060204, parting:3 ou drill:10; 2=drill:10 para a ferramenta 2</translation>
        </message>
        <message>
            <source>write as the first line: {columns}</source>
            <translation>escreva como primeira linha: {columns}</translation>
        </message>
        <message>
            <source>write both, as in: NAME = mild-steel 3 mm 45A</source>
            <translation>escreva os dois, como em: NAME = mild-steel 3 mm 45A</translation>
        </message>
        <message>
            <source>write distance = "absolute"</source>
            <translation>escreva distance = "absolute"</translation>
        </message>
        <message>
            <source>write each program so that it can run on its own</source>
            <translation>escreva cada programa de modo que funcione sozinho</translation>
        </message>
        <message>
            <source>write each turn</source>
            <translation>escreva cada volta</translation>
        </message>
        <message>
            <source>write endsub, or M99 in a subprogram of Fanuc's form</source>
            <translation>escreva endsub, ou M99 em um subprograma na forma Fanuc</translation>
        </message>
        <message>
            <source>write feed= and mm/min, for example feed=900</source>
            <translation>escreva feed= e mm/min, por exemplo feed=900</translation>
        </message>
        <message>
            <source>write fewer digits</source>
            <translation>escreva menos algarismos</translation>
        </message>
        <message>
            <source>write flatter tables</source>
            <translation>escreva tabelas mais rasas</translation>
        </message>
        <message>
            <source>write for example XYZ, or Z alone</source>
            <translation>escreva por exemplo XYZ, ou só Z</translation>
        </message>
        <message>
            <source>write for grbl or linuxcnc</source>
            <translation>escreva para grbl ou linuxcnc</translation>
        </message>
        <message>
            <source>write four letters and six digits, for example CNMG 120408</source>
            <translation>escreva quatro letras e seis algarismos, por exemplo CNMG 120408</translation>
        </message>
        <message>
            <source>write how many parts are wanted</source>
            <translation>escreva quantas peças são desejadas</translation>
        </message>
        <message>
            <source>write it as two</source>
            <translation>escreva-a em duas</translation>
        </message>
        <message>
            <source>write it in lines of its own</source>
            <translation>escreva-o em linhas próprias</translation>
        </message>
        <message>
            <source>write it in the controller's own: cncstepper convert PROGRAM --dialect {dialect} --to {own} -o NEW</source>
            <translation>escreva-o na linguagem do controlador: cncstepper convert PROGRAMA --dialect {dialect} --to {own} -o NOVO</translation>
        </message>
        <message>
            <source>write it in two lines, or make the comment shorter</source>
            <translation>escreva-a em duas linhas ou encurte o comentário</translation>
        </message>
        <message>
            <source>write it on a line of its own</source>
            <translation>escreva-o em uma linha própria</translation>
        </message>
        <message>
            <source>write it on the next line</source>
            <translation>escreva-o na linha seguinte</translation>
        </message>
        <message>
            <source>write its comment before, such as {example}, or name material and thickness</source>
            <translation>escreva antes o comentário dele, como {example}, ou indique material e espessura</translation>
        </message>
        <message>
            <source>write its end point</source>
            <translation>escreva o seu ponto final</translation>
        </message>
        <message>
            <source>write its endif, endwhile, endrepeat, while or endsub</source>
            <translation>escreva o seu endif, endwhile, endrepeat, while ou endsub</translation>
        </message>
        <message>
            <source>write length_mm = {length:.4g}, or lengthen the cylinder</source>
            <translation>escreva length_mm = {length:.4g}, ou alongue o cilindro</translation>
        </message>
        <message>
            <source>write mm</source>
            <translation>escreva em mm</translation>
        </message>
        <message>
            <source>write numbers in mm</source>
            <translation>escreva números em mm</translation>
        </message>
        <message>
            <source>write one of them</source>
            <translation>escreva um deles</translation>
        </message>
        <message>
            <source>write one of: {corner_of_origin}</source>
            <translation>escreva um destes: {corner_of_origin}</translation>
        </message>
        <message>
            <source>write one program a tool, or pause at tool changes</source>
            <translation>escreva um programa por ferramenta ou faça uma pausa nas trocas de ferramenta</translation>
        </message>
        <message>
            <source>write one such as M20x2.5, M20, 1/2-13 UNC, 1/4-28 UNF, 3/8-16 BSW, G1/2, Tr20x4 or Tr40x14P7</source>
            <translation>escreva uma como M20x2.5, M20, 1/2-13 UNC, 1/4-28 UNF, 3/8-16 BSW, G1/2, Tr20x4 ou Tr40x14P7</translation>
        </message>
        <message>
            <source>write one x,y in mm a line</source>
            <translation>escreva um x,y em mm por linha</translation>
        </message>
        <message>
            <source>write ph=, pd=, ch= and fr=</source>
            <translation>escreva ph=, pd=, ch= e fr=</translation>
        </message>
        <message>
            <source>write plain moves, each in a line of its own, in coordinates that are not turned</source>
            <translation>escreva movimentos simples, cada um em sua linha, em coordenadas não giradas</translation>
        </message>
        <message>
            <source>write rules: [[rule]]</source>
            <translation>escreva regras: [[rule]]</translation>
        </message>
        <message>
            <source>write shape:diameter_mm, for example flat:6 or ball:2</source>
            <translation>escreva forma:diâmetro_mm, por exemplo flat:6 ou ball:2</translation>
        </message>
        <message>
            <source>write socket://host:port</source>
            <translation>escreva socket://host:porta</translation>
        </message>
        <message>
            <source>write tcp://127.0.0.1:8786, or tls://HOST:8786</source>
            <translation>escreva tcp://127.0.0.1:8786, ou tls://HOST:8786</translation>
        </message>
        <message>
            <source>write the arc with more decimals</source>
            <translation>escreva o arco com mais decimais</translation>
        </message>
        <message>
            <source>write the chart as TOML</source>
            <translation>escreva a tabela em TOML</translation>
        </message>
        <message>
            <source>write the curve as lines and arcs</source>
            <translation>escreva a curva como retas e arcos</translation>
        </message>
        <message>
            <source>write the cuts as [[operation]]</source>
            <translation>escreva o que deve ser cortado como [[operation]]</translation>
        </message>
        <message>
            <source>write the end point itself</source>
            <translation>escreva o próprio ponto final</translation>
        </message>
        <message>
            <source>write the motion word again</source>
            <translation>escreva de novo a palavra de movimento</translation>
        </message>
        <message>
            <source>write the name of a file</source>
            <translation>escreva o nome de um arquivo</translation>
        </message>
        <message>
            <source>write the path of the tool's centre</source>
            <translation>escreva o percurso do centro da ferramenta</translation>
        </message>
        <message>
            <source>write the program for the dialect fluidnc or grbl</source>
            <translation>escreva o programa para o dialeto fluidnc ou grbl</translation>
        </message>
        <message>
            <source>write the program for the dialect grbl</source>
            <translation>gere o programa para o dialeto grbl</translation>
        </message>
        <message>
            <source>write the program for the dialect grblhal or grbl</source>
            <translation>escreva o programa para o dialeto grblhal ou grbl</translation>
        </message>
        <message>
            <source>write the program for the dialect mini-lathe</source>
            <translation>escreva o programa para o dialeto mini-lathe</translation>
        </message>
        <message>
            <source>write the program in mm, or choose a higher feed</source>
            <translation>escreva o programa em mm ou escolha um avanço maior</translation>
        </message>
        <message>
            <source>write the value itself</source>
            <translation>escreva o próprio valor</translation>
        </message>
        <message>
            <source>write the words with plain numbers</source>
            <translation>escreva as palavras com números simples</translation>
        </message>
        <message>
            <source>write them on two lines</source>
            <translation>escreva-os em duas linhas</translation>
        </message>
        <message>
            <source>write those</source>
            <translation>escreva essas</translation>
        </message>
        <message>
            <source>write to another one</source>
            <translation>grave em outro</translation>
        </message>
        <message>
            <source>write with G54 to G59</source>
            <translation>escreva com G54 a G59</translation>
        </message>
        <message>
            <source>write x,y in mm, or x;y where the comma is the decimal sign</source>
            <translation>escreva x,y em mm, ou x;y onde a vírgula é o sinal decimal</translation>
        </message>
        <message>
            <source>write x_is = "radius"</source>
            <translation>escreva x_is = "radius"</translation>
        </message>
        <message>
            <source>write {0} to {1}</source>
            <translation>escreva de {0} a {1}</translation>
        </message>
        <message>
            <source>write {keyword} [condition]</source>
            <translation>escreva {keyword} [condição]</translation>
        </message>
        <message>
            <source>write {key} = "file"</source>
            <translation>escreva {key} = "arquivo"</translation>
        </message>
        <message>
            <source>write {key} = "name"</source>
            <translation>escreva {key} = "nome"</translation>
        </message>
        <message>
            <source>write {number} within these bounds: {why}</source>
            <translation>escreva {number} dentro destes limites: {why}</translation>
        </message>
        <message>
            <source>write {other} alone</source>
            <translation>escreva só {other}</translation>
        </message>
        <message>
            <source>write {word} before</source>
            <translation>escreva {word} antes</translation>
        </message>
        <message>
            <source>x y width height</source>
            <translation>x y largura altura</translation>
        </message>
        <message>
            <source>x_is = diameter</source>
            <translation>x_is = diameter</translation>
        </message>
        <message>
            <source>z {0} mm at most</source>
            <translation>z {0} mm no máximo</translation>
        </message>
        <message>
            <source>zero of</source>
            <translation>zero de</translation>
        </message>
        <message>
            <source>zero of {axes} set in {system}</source>
            <translation>zero de {axes} definido em {system}</translation>
        </message>
        <message>
            <source>{0} (not offered)</source>
            <translation>{0} (sem oferta)</translation>
        </message>
        <message>
            <source>{0} MB, {1} files</source>
            <translation>{0} MB, {1} arquivos</translation>
        </message>
        <message>
            <source>{0} and {1} mm</source>
            <translation>{0} e {1} mm</translation>
        </message>
        <message>
            <source>{0} by the template {1}, {2}</source>
            <translation>{0} pelo modelo {1}, {2}</translation>
        </message>
        <message>
            <source>{0} by {1} mm</source>
            <translation>{0} por {1} mm</translation>
        </message>
        <message>
            <source>{0} by {1} to {2} mm</source>
            <translation>{0} de {1} a {2} mm</translation>
        </message>
        <message>
            <source>{0} cm³, {1} of the solid</source>
            <translation>{0} cm³, {1} do sólido</translation>
        </message>
        <message>
            <source>{0} in islands {1}</source>
            <translation>{0} em ilhas {1}</translation>
        </message>
        <message>
            <source>{0} is refused</source>
            <translation>{0} foi recusado</translation>
        </message>
        <message>
            <source>{0} mm deep</source>
            <translation>{0} mm de profundidade</translation>
        </message>
        <message>
            <source>{0} mm each where the axes are square</source>
            <translation>{0} mm cada, com os eixos em esquadro</translation>
        </message>
        <message>
            <source>{0} mm long</source>
            <translation>{0} mm de comprimento</translation>
        </message>
        <message>
            <source>{0} mm/min</source>
            <translation>{0} mm/min</translation>
        </message>
        <message>
            <source>{0} open edges</source>
            <translation>{0} arestas abertas</translation>
        </message>
        <message>
            <source>{0} parts on {1} sheets, {2} m cut, {3} pierces, {4} hours of the machine</source>
            <translation>{0} peças em {1} chapas, {2} m cortados, {3} perfurações, {4} horas de máquina</translation>
        </message>
        <message>
            <source>{0} parts without a place</source>
            <translation>{0} peças sem lugar</translation>
        </message>
        <message>
            <source>{0} segments fewer</source>
            <translation>{0} segmentos a menos</translation>
        </message>
        <message>
            <source>{0} sheets of {1} mm</source>
            <translation>{0} chapas de {1} mm</translation>
        </message>
        <message>
            <source>{0} to {1} mm</source>
            <translation>{0} a {1} mm</translation>
        </message>
        <message>
            <source>{0} to {1} mm from here</source>
            <translation>{0} a {1} mm daqui</translation>
        </message>
        <message>
            <source>{0} to {1} mm/min</source>
            <translation>{0} a {1} mm/min</translation>
        </message>
        <message>
            <source>{0} units an em</source>
            <translation>{0} unidades por em</translation>
        </message>
        <message>
            <source>{0} without a place</source>
            <translation>{0} sem lugar</translation>
        </message>
        <message>
            <source>{0}, program {1} of {2}</source>
            <translation>{0}, programa {1} de {2}</translation>
        </message>
        <message>
            <source>{absent} is absent: the axis stays here, but the published control would drive it to 0</source>
            <translation>falta {absent}: aqui o eixo fica parado, mas o comando publicado o levaria para 0</translation>
        </message>
        <message>
            <source>{asked}; a {other} is used</source>
            <translation>{asked}; usa-se: {other}</translation>
        </message>
        <message>
            <source>{away_mm:.3f} mm away</source>
            <translation>a {away_mm:.3f} mm de distância</translation>
        </message>
        <message>
            <source>{beyond_mm:.3f} mm beyond</source>
            <translation>{beyond_mm:.3f} mm além</translation>
        </message>
        <message>
            <source>{body} goes into clamp {number}</source>
            <translation>{body} bate no grampo {number}</translation>
        </message>
        <message>
            <source>{centre_word} is no centre word in plane {name}</source>
            <translation>{centre_word} não é palavra de centro no plano {name}</translation>
        </message>
        <message>
            <source>{chain}: the kerf does not get into a slot or corner at X{x:.3f} Y{y:.3f}; {left_mm:.2f} mm stay</source>
            <translation>{chain}: a largura do corte não entra em um rasgo ou canto em X{x:.3f} Y{y:.3f}; ficam {left_mm:.2f} mm</translation>
        </message>
        <message>
            <source>{clear_mm:g} mm with the stock to leave</source>
            <translation>{clear_mm:g} mm com o sobremetal</translation>
        </message>
        <message>
            <source>{code} and {code2} may not share a line: they set the same mode</source>
            <translation>{code} e {code2} não podem ficar na mesma linha: definem o mesmo modo</translation>
        </message>
        <message>
            <source>{code} needs X, Y or Z</source>
            <translation>{code} precisa de X, Y ou Z</translation>
        </message>
        <message>
            <source>{code} needs a {letter} word</source>
            <translation>{code} precisa de uma palavra {letter}</translation>
        </message>
        <message>
            <source>{counts} at one place</source>
            <translation>{counts} num só lugar</translation>
        </message>
        <message>
            <source>{count} characters</source>
            <translation>{count} caracteres</translation>
        </message>
        <message>
            <source>{count} clip paths and masks are not applied: the parts that they hide are read too</source>
            <translation>{count} recortes e máscaras não são aplicados: o que eles escondem também é lido</translation>
        </message>
        <message>
            <source>{count} copies have {places} places</source>
            <translation>{count} cópias têm {places} lugares</translation>
        </message>
        <message>
            <source>{count} copies of {name} have no place on the work surface</source>
            <translation>{count} cópias de {name} não têm lugar na superfície de trabalho</translation>
        </message>
        <message>
            <source>{count} dashed strokes are read as whole lines</source>
            <translation>{count} traços tracejados são lidos como linhas contínuas</translation>
        </message>
        <message>
            <source>{count} joints do not fit on {chain}</source>
            <translation>{count} microjunções não cabem em {chain}</translation>
        </message>
        <message>
            <source>{count} lines have markers, which are not read</source>
            <translation>{count} linhas têm marcadores, que não são lidos</translation>
        </message>
        <message>
            <source>{count} paths are damaged and read up to the damage</source>
            <translation>{count} caminhos estão danificados e são lidos até o dano</translation>
        </message>
        <message>
            <source>{count} pulses do not fit: no room, or ticks that do not rise</source>
            <translation>{count} pulsos não cabem: falta espaço, ou os tempos não crescem</translation>
        </message>
        <message>
            <source>{count} texts are longer than their path; letters beyond it are left out: {names}</source>
            <translation>{count} textos são mais longos que o seu caminho; as letras além dele são omitidas: {names}</translation>
        </message>
        <message>
            <source>{count} texts are set in another font or style than the file names: {names}</source>
            <translation>{count} textos são compostos em outra fonte ou estilo que os do arquivo: {names}</translation>
        </message>
        <message>
            <source>{count} texts with places inside their textLength are not brought to it</source>
            <translation>{count} textos com posições dentro do seu textLength não são ajustados a ele</translation>
        </message>
        <message>
            <source>{count} transforms are damaged and not applied</source>
            <translation>{count} transformações estão danificadas e não são aplicadas</translation>
        </message>
        <message>
            <source>{crossing} rapid(s) lead over parts that are already free</source>
            <translation>{crossing} rápido(s) passa(m) sobre peças já soltas</translation>
        </message>
        <message>
            <source>{deep_mm:.3f} mm deep</source>
            <translation>{deep_mm:.3f} mm de profundidade</translation>
        </message>
        <message>
            <source>{depth:.3g} mm deep, or {rpm:.4g} rpm, would do</source>
            <translation>{depth:.3g} mm de profundidade, ou {rpm:.4g} rpm, serviriam</translation>
        </message>
        <message>
            <source>{dialect} answers {answer}</source>
            <translation>{dialect} responde {answer}</translation>
        </message>
        <message>
            <source>{dialect} cannot switch the power off between two cuts</source>
            <translation>{dialect} não consegue desligar a potência entre dois cortes</translation>
        </message>
        <message>
            <source>{dialect} does not accept {name}</source>
            <translation>{dialect} não aceita {name}</translation>
        </message>
        <message>
            <source>{dialect} has no axis {letter}</source>
            <translation>{dialect} não tem eixo {letter}</translation>
        </message>
        <message>
            <source>{dialect} has no programs in {units}</source>
            <translation>{dialect} não tem programas em {units}</translation>
        </message>
        <message>
            <source>{dialect} has no word for X as a diameter</source>
            <translation>{dialect} não tem palavra para X como diâmetro</translation>
        </message>
        <message>
            <source>{dialect} has no word {letter}</source>
            <translation>{dialect} não tem a palavra {letter}</translation>
        </message>
        <message>
            <source>{dialect} has no work offset {name}</source>
            <translation>{dialect} não tem o sistema de coordenadas {name}</translation>
        </message>
        <message>
            <source>{dialect} has no {what}</source>
            <translation>{dialect} não tem {what}</translation>
        </message>
        <message>
            <source>{dialect} programs are written without '{code}'</source>
            <translation>programas {dialect} são escritos sem '{code}'</translation>
        </message>
        <message>
            <source>{dialect} programs are written without '{event_kind}'</source>
            <translation>programas de {dialect} são escritos sem '{event_kind}'</translation>
        </message>
        <message>
            <source>{doing} failed by a fault of its own: {kind}: {error}</source>
            <translation>{doing} falhou por um defeito próprio: {kind}: {error}</translation>
        </message>
        <message>
            <source>{doing} takes more memory than there is</source>
            <translation>{doing} precisa de mais memória do que há</translation>
        </message>
        <message>
            <source>{doubles} boundaries of hatches are drawn as lines too; they are read once</source>
            <translation>{doubles} fronteiras de hachuras também estão desenhadas como linhas; são lidas uma só vez</translation>
        </message>
        <message>
            <source>{ends} of {curves} open, the first from {end}</source>
            <translation>{ends} de {curves} abertas, a primeira a partir de {end}</translation>
        </message>
        <message>
            <source>{error}. Now {state}</source>
            <translation>{error}. Agora {state}</translation>
        </message>
        <message>
            <source>{far_mm:.3f} mm away</source>
            <translation>{far_mm:.3f} mm de distância</translation>
        </message>
        <message>
            <source>{far_mm:.3f} mm from the tool's centre</source>
            <translation>{far_mm:.3f} mm do centro da ferramenta</translation>
        </message>
        <message>
            <source>{feed_mm_min:g} mm/min</source>
            <translation>{feed_mm_min:g} mm/min</translation>
        </message>
        <message>
            <source>{field:g} to {field2:g} mm</source>
            <translation>{field:g} a {field2:g} mm</translation>
        </message>
        <message>
            <source>{file}, {total} lines to send</source>
            <translation>{file}, {total} linhas a enviar</translation>
        </message>
        <message>
            <source>{first_file}: restart that one again; its restart's cuts count as cut</source>
            <translation>{first_file}: reinicie esse de novo; o que o reinício dele cortou conta como cortado</translation>
        </message>
        <message>
            <source>{first_mm:g} to {last_mm:g} mm</source>
            <translation>{first_mm:g} a {last_mm:g} mm</translation>
        </message>
        <message>
            <source>{gap_mm:g} mm each, the kerf included</source>
            <translation>{gap_mm:g} mm cada uma, com a largura do corte</translation>
        </message>
        <message>
            <source>{hanging} piece(s) stay joined to others, for the tool does not fit between them; the tightest place is at X{x:.3f} Y{y:.3f}</source>
            <translation>{hanging} peça(s) fica(m) unida(s) a outras, pois a ferramenta não cabe entre elas; o lugar mais estreito fica em X{x:.3f} Y{y:.3f}</translation>
        </message>
        <message>
            <source>{high:g} by {high2:g} mm</source>
            <translation>{high:g} por {high2:g} mm</translation>
        </message>
        <message>
            <source>{holes} closed hole(s)</source>
            <translation>{holes} furo(s) fechado(s)</translation>
        </message>
        <message>
            <source>{home}, and end other programs before the next try</source>
            <translation>{home}, e feche outros programas antes de tentar de novo</translation>
        </message>
        <message>
            <source>{inside} of {runs} runs cannot be entered from the side; a {kind} is used</source>
            <translation>{inside} de {runs} percursos não podem ser entrados pelo lado; usa-se {kind}</translation>
        </message>
        <message>
            <source>{interval} (work, mm)</source>
            <translation>{interval} (peça, mm)</translation>
        </message>
        <message>
            <source>{job} has no program: {why}</source>
            <translation>{job} não tem programa: {why}</translation>
        </message>
        <message>
            <source>{keeper} was refused</source>
            <translation>{keeper} foi recusado</translation>
        </message>
        <message>
            <source>{kerf_mm:g} mm from the other holes</source>
            <translation>{kerf_mm:g} mm dos outros furos</translation>
        </message>
        <message>
            <source>{kerf_share:.4g} to {kerf_share2:.4g} mm</source>
            <translation>{kerf_share:.4g} a {kerf_share2:.4g} mm</translation>
        </message>
        <message>
            <source>{key} cannot be '{value}'</source>
            <translation>{key} não pode ser '{value}'</translation>
        </message>
        <message>
            <source>{key} cannot be {value}: {error}</source>
            <translation>{key} não pode ser {value}: {error}</translation>
        </message>
        <message>
            <source>{key} goes beyond what the machine can travel</source>
            <translation>{key} vai além do curso da máquina</translation>
        </message>
        <message>
            <source>{key} goes far beyond the machine's fastest axis</source>
            <translation>{key} vai muito além do eixo mais rápido da máquina</translation>
        </message>
        <message>
            <source>{key} goes far beyond the stock</source>
            <translation>{key} vai muito além da peça bruta</translation>
        </message>
        <message>
            <source>{key} goes far beyond the stock and the machine</source>
            <translation>{key} vai muito além da peça bruta e da máquina</translation>
        </message>
        <message>
            <source>{key} has too few values</source>
            <translation>{key} tem valores de menos</translation>
        </message>
        <message>
            <source>{key} is missing, and only the circles of a drawing have one of their own</source>
            <translation>{key} falta, e só os círculos de um desenho têm um próprio</translation>
        </message>
        <message>
            <source>{key} is too long</source>
            <translation>{key} é longo demais</translation>
        </message>
        <message>
            <source>{key} is twice in one material</source>
            <translation>{key} aparece duas vezes em um material</translation>
        </message>
        <message>
            <source>{key} leads into a value that is no table</source>
            <translation>{key} leva a um valor que não é tabela</translation>
        </message>
        <message>
            <source>{key} must be a list of tables</source>
            <translation>{key} deve ser uma lista de tabelas</translation>
        </message>
        <message>
            <source>{key} must be a number</source>
            <translation>{key} deve ser um número</translation>
        </message>
        <message>
            <source>{key} must be the name of a shape, or a list of names</source>
            <translation>{key} tem de ser o nome de uma forma ou uma lista de nomes</translation>
        </message>
        <message>
            <source>{key} must be {number} within its bounds</source>
            <translation>{key} deve ser {number} dentro de seus limites</translation>
        </message>
        <message>
            <source>{key} must name a file</source>
            <translation>{key} deve nomear um arquivo</translation>
        </message>
        <message>
            <source>{key} names the shape '{name}' twice</source>
            <translation>{key} nomeia a forma '{name}' duas vezes</translation>
        </message>
        <message>
            <source>{key} names the shape '{name}', which the job does not have</source>
            <translation>{key} nomeia a forma '{name}', que o trabalho não tem</translation>
        </message>
        <message>
            <source>{key} needs X, Y or X, Y, Z</source>
            <translation>{key} precisa de X, Y ou X, Y, Z</translation>
        </message>
        <message>
            <source>{key} needs a closed shape, but '{name}' does not end where it begins</source>
            <translation>{key} precisa de uma forma fechada, mas '{name}' não termina onde começa</translation>
        </message>
        <message>
            <source>{key} needs a laser: {process} has one power and pierces anew</source>
            <translation>{key} precisa de um laser: {process} tem uma só potência e perfura de novo</translation>
        </message>
        <message>
            <source>{key} of material {number}</source>
            <translation>{key} do material {number}</translation>
        </message>
        <message>
            <source>{key} of material {number} has no such value</source>
            <translation>{key} do material {number} não pode ter esse valor</translation>
        </message>
        <message>
            <source>{key}= is twice in a material's comment</source>
            <translation>{key}= aparece duas vezes no comentário de um material</translation>
        </message>
        <message>
            <source>{key}= of a material has no such value</source>
            <translation>{key}= de um material não pode ter esse valor</translation>
        </message>
        <message>
            <source>{key}= of a material is out of its bounds</source>
            <translation>{key}= de um material está fora de seus limites</translation>
        </message>
        <message>
            <source>{kind} on layer '{layer}' at X{x:.3f} Y{y:.3f}, {size}</source>
            <translation>{kind} na camada '{layer}' em X{x:.3f} Y{y:.3f}, {size}</translation>
        </message>
        <message>
            <source>{kind} on layer '{layer}' at X{x:.3f} Y{y:.3f}{length}</source>
            <translation>{kind} na camada '{layer}' em X{x:.3f} Y{y:.3f}{length}</translation>
        </message>
        <message>
            <source>{lacks} became lines, at most {chord_mm:g} mm away</source>
            <translation>{lacks} viraram retas, afastadas no máximo {chord_mm:g} mm</translation>
        </message>
        <message>
            <source>{late_ms:.0f} ms without a pulse</source>
            <translation>{late_ms:.0f} ms sem pulso</translation>
        </message>
        <message>
            <source>{late_ns:.0f} µs late</source>
            <translation>{late_ns:.0f} µs de atraso</translation>
        </message>
        <message>
            <source>{left:g} {operator} {right:g} is no finite number</source>
            <translation>{left:g} {operator} {right:g} não é um número finito</translation>
        </message>
        <message>
            <source>{left_out} corner(s) get no loop: there is no scrap for it</source>
            <translation>{left_out} canto(s) fica(m) sem laço: não há retalho para isso</translation>
        </message>
        <message>
            <source>{left_out} messages were left out: more came than could be read</source>
            <translation>{left_out} mensagens foram omitidas: chegaram mais do que se podia ler</translation>
        </message>
        <message>
            <source>{length_mm:.3f} mm to ramp on</source>
            <translation>{length_mm:.3f} mm para a rampa</translation>
        </message>
        <message>
            <source>{length_mm:g} mm, {feed_mm_min:g} mm/min</source>
            <translation>{length_mm:g} mm, {feed_mm_min:g} mm/min</translation>
        </message>
        <message>
            <source>{length} characters, {text} with spaces</source>
            <translation>{length} caracteres, {text} com espaços</translation>
        </message>
        <message>
            <source>{letter} continues from the last point: neither with {other} nor under G91</source>
            <translation>{letter} continua a partir do ponto anterior: nem com {other} nem sob G91</translation>
        </message>
        <message>
            <source>{letter} has no meaning with G10 L{kind}</source>
            <translation>{letter} não diz nada com G10 L{kind}</translation>
        </message>
        <message>
            <source>{letter} is out of range</source>
            <translation>{letter} está fora da faixa</translation>
        </message>
        <message>
            <source>{letter} is twice on the line</source>
            <translation>{letter} aparece duas vezes na linha</translation>
        </message>
        <message>
            <source>{letter} may not be negative</source>
            <translation>{letter} não pode ser negativo</translation>
        </message>
        <message>
            <source>{letter} must be a whole number</source>
            <translation>{letter} deve ser um número inteiro</translation>
        </message>
        <message>
            <source>{letter} of {name} must be {word} 0</source>
            <translation>o {letter} de {name} deve ser {word} 0</translation>
        </message>
        <message>
            <source>{limit_mm:g} mm high</source>
            <translation>{limit_mm:g} mm de altura</translation>
        </message>
        <message>
            <source>{limit_ms:.0f} ms</source>
            <translation>{limit_ms:.0f} ms</translation>
        </message>
        <message>
            <source>{line_characters} characters, {window_bytes} with spaces</source>
            <translation>{line_characters} caracteres, {window_bytes} com espaços</translation>
        </message>
        <message>
            <source>{lines} lines more than the text has</source>
            <translation>{lines} linhas a mais do que o texto tem</translation>
        </message>
        <message>
            <source>{line} has no {keywords} with the label {line2} before it</source>
            <translation>{line} não tem antes um {keywords} com o rótulo {line2}</translation>
        </message>
        <message>
            <source>{line} is in line {index} of {known_file} already</source>
            <translation>{line} já está na linha {index} de {known_file}</translation>
        </message>
        <message>
            <source>{line} is outside any subroutine</source>
            <translation>{line} está fora de qualquer sub-rotina</translation>
        </message>
        <message>
            <source>{link} answered '{answer}' to no line</source>
            <translation>{link} respondeu '{answer}' a nenhuma linha</translation>
        </message>
        <message>
            <source>{link} does not answer {line}</source>
            <translation>{link} não responde a {line}</translation>
        </message>
        <message>
            <source>{link} does not report its modes: question or answer was damaged</source>
            <translation>{link} não informa seus modos: a pergunta ou a resposta foi danificada</translation>
        </message>
        <message>
            <source>{link} restarted while it was asked</source>
            <translation>{link} reiniciou enquanto era consultado</translation>
        </message>
        <message>
            <source>{link} runs grbl {version}</source>
            <translation>{link} usa grbl {version}</translation>
        </message>
        <message>
            <source>{link} sends no line ends</source>
            <translation>{link} não envia fins de linha</translation>
        </message>
        <message>
            <source>{machine} accepts no pulse letters</source>
            <translation>{machine} não aceita letras de pulso</translation>
        </message>
        <message>
            <source>{machine} at {port}, grbl {firmware}, begun {begin}</source>
            <translation>{machine} em {port}, grbl {firmware}, iniciado em {begin}</translation>
        </message>
        <message>
            <source>{machine} does not cut by {process}</source>
            <translation>{machine} não corta com {process}</translation>
        </message>
        <message>
            <source>{machine} has a controller of its own</source>
            <translation>{machine} tem um controlador próprio</translation>
        </message>
        <message>
            <source>{machine} has a laser, whose beam would not be in time with its moves</source>
            <translation>{machine} tem um laser, cujo feixe não acompanharia os movimentos</translation>
        </message>
        <message>
            <source>{machine} has no axis {axis}</source>
            <translation>{machine} não tem o eixo {axis}</translation>
        </message>
        <message>
            <source>{machine} has no relay '{name}'</source>
            <translation>{machine} não tem o relé '{name}'</translation>
        </message>
        <message>
            <source>{machine} takes no sheets: it has no Y</source>
            <translation>{machine} não recebe chapas: não tem Y</translation>
        </message>
        <message>
            <source>{match} is no number</source>
            <translation>{match} não é um número</translation>
        </message>
        <message>
            <source>{meaning} (error:{error})</source>
            <translation>{meaning} (error:{error})</translation>
        </message>
        <message>
            <source>{missing} cut(s) end without a lead-out: there is no scrap for it</source>
            <translation>{missing} corte(s) termina(m) sem saída: não há retalho para isso</translation>
        </message>
        <message>
            <source>{missing} is missing: absolute arc centres need both words</source>
            <translation>falta {missing}: centros de arco absolutos precisam das duas palavras</translation>
        </message>
        <message>
            <source>{moment}, OFF the path of these lines</source>
            <translation>{moment}, FORA do caminho destas linhas</translation>
        </message>
        <message>
            <source>{moment}, on the path at line {seen_line}</source>
            <translation>{moment}, no caminho, na linha {seen_line}</translation>
        </message>
        <message>
            <source>{more} {rest_mm:.3f} mm of material stays in {corners} inside corner(s) that are sharper than the tool; {told}</source>
            <translation>{more} {rest_mm:.3f} mm de material fica em {corners} canto(s) interno(s) mais vivo(s) que a ferramenta; {told}</translation>
        </message>
        <message>
            <source>{most_mm:.2f} mm each</source>
            <translation>{most_mm:.2f} mm cada uma</translation>
        </message>
        <message>
            <source>{most_strokes} moves in one block</source>
            <translation>{most_strokes} movimentos em um bloco</translation>
        </message>
        <message>
            <source>{most} pixels</source>
            <translation>{most} pixels</translation>
        </message>
        <message>
            <source>{named} cannot change tools by '{tool_change}'</source>
            <translation>{named} não pode trocar ferramentas por '{tool_change}'</translation>
        </message>
        <message>
            <source>{name} and {other} may not share a line: they use the same word</source>
            <translation>{name} e {other} não podem dividir uma linha: usam a mesma palavra</translation>
        </message>
        <message>
            <source>{name} asks for more than {most_passes} passes</source>
            <translation>{name} pede mais de {most_passes} passes</translation>
        </message>
        <message>
            <source>{name} became plain moves</source>
            <translation>{name} virou movimentos simples</translation>
        </message>
        <message>
            <source>{name} cannot be had: {error}</source>
            <translation>não foi possível abrir {name}: {error}</translation>
        </message>
        <message>
            <source>{name} cannot be used as a serial port: {text}</source>
            <translation>{name} não pode ser usado como porta serial: {text}</translation>
        </message>
        <message>
            <source>{name} has no feed</source>
            <translation>{name} não tem avanço</translation>
        </message>
        <message>
            <source>{name} has no feed: a feed per turn needs F and a spindle that turns</source>
            <translation>{name} não tem avanço: um avanço por rotação precisa de F e de um spindle girando</translation>
        </message>
        <message>
            <source>{name} has no value for {argument:g}</source>
            <translation>{name} não tem valor para {argument:g}</translation>
        </message>
        <message>
            <source>{name} is a parallel port, and the machine is a board</source>
            <translation>{name} é uma porta paralela, e a máquina é uma placa</translation>
        </message>
        <message>
            <source>{name} is a parallel port, on which there is no controller</source>
            <translation>{name} é uma porta paralela, em que não há controlador</translation>
        </message>
        <message>
            <source>{name} is between G5.2 and G5.3</source>
            <translation>{name} está entre G5.2 e G5.3</translation>
        </message>
        <message>
            <source>{name} is in use</source>
            <translation>{name} está em uso</translation>
        </message>
        <message>
            <source>{name} is no object</source>
            <translation>{name} não é um objeto</translation>
        </message>
        <message>
            <source>{name} is no port for pulses</source>
            <translation>{name} não é uma porta que receba pulsos</translation>
        </message>
        <message>
            <source>{name} is no port: {text}</source>
            <translation>{name} não é uma porta: {text}</translation>
        </message>
        <message>
            <source>{name} is not read in {plane}, a plane of the axes U, V and W</source>
            <translation>{name} não é lido em {plane}, um plano dos eixos U, V e W</translation>
        </message>
        <message>
            <source>{name} is not reported</source>
            <translation>{name} não é informado</translation>
        </message>
        <message>
            <source>{name} is read in the plane XY only: LinuxCNC moves along the wrong axes in {plane_code}</source>
            <translation>{name} só é lido no plano XY: o LinuxCNC move os eixos errados em {plane_code}</translation>
        </message>
        <message>
            <source>{name} is {offset}, wanted {wanted} mm</source>
            <translation>{name} é {offset}, esperado {wanted} mm</translation>
        </message>
        <message>
            <source>{name} lists no such alarm</source>
            <translation>{name} não lista esse alarme</translation>
        </message>
        <message>
            <source>{name} lists no such error</source>
            <translation>{name} não lista esse erro</translation>
        </message>
        <message>
            <source>{name} may not be assigned</source>
            <translation>{name} não pode receber um valor</translation>
        </message>
        <message>
            <source>{name} may not be opened by this user</source>
            <translation>{name} não pode ser aberta por este usuário</translation>
        </message>
        <message>
            <source>{name} may not be used</source>
            <translation>{name} não pode ser usado</translation>
        </message>
        <message>
            <source>{name} moves with the spindle, whose speed is not set</source>
            <translation>{name} se move com o spindle, cuja rotação não foi definida</translation>
        </message>
        <message>
            <source>{name} needs a {letter} word</source>
            <translation>{name} precisa de uma palavra {letter}</translation>
        </message>
        <message>
            <source>{name} needs a {letter} word: none is in force</source>
            <translation>{name} precisa de uma palavra {letter}: nenhuma está em vigor</translation>
        </message>
        <message>
            <source>{name} needs both I and J</source>
            <translation>{name} precisa de I e J</translation>
        </message>
        <message>
            <source>{name} needs the spindle to turn</source>
            <translation>{name} precisa que o spindle gire</translation>
        </message>
        <message>
            <source>{name} needs the spindle to turn clockwise (M3)</source>
            <translation>{name} precisa que o spindle gire no sentido horário (M3)</translation>
        </message>
        <message>
            <source>{name} needs the spindle to turn counter-clockwise (M4)</source>
            <translation>{name} precisa que o spindle gire no sentido anti-horário (M4)</translation>
        </message>
        <message>
            <source>{name} needs the whole program: the profile is a subroutine</source>
            <translation>{name} precisa do programa inteiro: o perfil é uma sub-rotina</translation>
        </message>
        <message>
            <source>{name} sends more than was asked for</source>
            <translation>{name} envia mais do que foi pedido</translation>
        </message>
        <message>
            <source>{name} takes no F: the spindle drives it</source>
            <translation>{name} não aceita F: o spindle o conduz</translation>
        </message>
        <message>
            <source>{name} was set before</source>
            <translation>{name} foi definido antes</translation>
        </message>
        <message>
            <source>{name} works in the plane ZX</source>
            <translation>{name} funciona no plano ZX</translation>
        </message>
        <message>
            <source>{number:.0f} pulses/s, the worst {worst_us:.0f} µs late</source>
            <translation>{number:.0f} pulsos/s, o pior com {worst_us:.0f} µs de atraso</translation>
        </message>
        <message>
            <source>{obj} follows one drawing</source>
            <translation>{obj} segue um só desenho</translation>
        </message>
        <message>
            <source>{obj} has no '{unknown}'</source>
            <translation>{obj} não tem '{unknown}'</translation>
        </message>
        <message>
            <source>{obj} has no drawing</source>
            <translation>{obj} não tem desenho</translation>
        </message>
        <message>
            <source>{obj} has no tool</source>
            <translation>{obj} não tem ferramenta</translation>
        </message>
        <message>
            <source>{obj} is not cut by {process}</source>
            <translation>{obj} não se corta por {process}</translation>
        </message>
        <message>
            <source>{one} and {other} cut into each other</source>
            <translation>{one} e {other} cortam um ao outro</translation>
        </message>
        <message>
            <source>{one} cuts into a piece that {other} has set free: nothing holds it</source>
            <translation>{one} corta uma peça que {other} já soltou: nada a segura</translation>
        </message>
        <message>
            <source>{owner} by way of a place cannot be turned</source>
            <translation>{owner} passando por um ponto não pode ser girado</translation>
        </message>
        <message>
            <source>{owner} sets the zero from where the tool stands after moves of the path</source>
            <translation>{owner} define o zero a partir de onde a ferramenta está depois de movimentos do percurso</translation>
        </message>
        <message>
            <source>{package} is not installed</source>
            <translation>{package} não está instalado</translation>
        </message>
        <message>
            <source>{path} cannot be read: {error}</source>
            <translation>{path} não pode ser lido: {error}</translation>
        </message>
        <message>
            <source>{path} cannot be recorded in: {error}</source>
            <translation>não é possível gravar em {path}: {error}</translation>
        </message>
        <message>
            <source>{path} cannot be written: {error}</source>
            <translation>não é possível gravar {path}: {error}</translation>
        </message>
        <message>
            <source>{path} has no pins to read: {error}</source>
            <translation>{path} não tem pinos para ler: {error}</translation>
        </message>
        <message>
            <source>{path} is JSON: only TOML profiles are changed</source>
            <translation>{path} é JSON: só perfis TOML são mudados</translation>
        </message>
        <message>
            <source>{path} is no parallel port that can be had: {error}</source>
            <translation>não é possível usar {path} como porta paralela: {error}</translation>
        </message>
        <message>
            <source>{path} is no recording of pulses, and is not written over</source>
            <translation>{path} não é uma gravação de pulsos e não é sobrescrito</translation>
        </message>
        <message>
            <source>{per_s:.0f} pulses/s, {stall_us:.0f} µs</source>
            <translation>{per_s:.0f} pulsos/s, {stall_us:.0f} µs</translation>
        </message>
        <message>
            <source>{pierce_mm:g} mm from parts</source>
            <translation>{pierce_mm:g} mm das peças</translation>
        </message>
        <message>
            <source>{pierce_mm:g} mm from parts and cut edges</source>
            <translation>{pierce_mm:g} mm das peças e das bordas cortadas</translation>
        </message>
        <message>
            <source>{places} of {wanted} tabs fit on the contour that begins at X{x:.3f} Y{y:.3f}; make them narrower to fit more</source>
            <translation>{places} de {wanted} pontes cabem no contorno que começa em X{x:.3f} Y{y:.3f}; estreite-as para ter mais</translation>
        </message>
        <message>
            <source>{plain} has no setting '{setting}'</source>
            <translation>{plain} não tem o ajuste '{setting}'</translation>
        </message>
        <message>
            <source>{port} is connected as {there}, not as {machine}</source>
            <translation>{port} está conectada como {there}, não como {machine}</translation>
        </message>
        <message>
            <source>{port} is held by a job of yours, {status_file}, which is {phase}</source>
            <translation>{port} está ocupada por um trabalho seu, {status_file}, no estado {phase}</translation>
        </message>
        <message>
            <source>{port} is held by a process of yours that does not answer</source>
            <translation>{port} está em uso por um processo seu que não responde</translation>
        </message>
        <message>
            <source>{port} is in use by another window's connection</source>
            <translation>{port} está em uso pela conexão de outra janela</translation>
        </message>
        <message>
            <source>{port} may be held by another connection of yours</source>
            <translation>{port} pode estar ocupada por outra conexão sua</translation>
        </message>
        <message>
            <source>{port}, grbl {firmware}, begun {begin}</source>
            <translation>{port}, grbl {firmware}, iniciado em {begin}</translation>
        </message>
        <message>
            <source>{problem} in {table}</source>
            <translation>{problem} em {table}</translation>
        </message>
        <message>
            <source>{process} does not cut through the sheet: it needs no tabs</source>
            <translation>{process} não corta através da chapa: não precisa de pontes</translation>
        </message>
        <message>
            <source>{process} does not cut with a {shape} tool</source>
            <translation>{process} não corta com uma ferramenta {shape}</translation>
        </message>
        <message>
            <source>{process} does not cut with a {shape} tool; its shape is one of: {shapes}</source>
            <translation>{process} não corta com uma ferramenta {shape}; a forma é uma de: {shapes}</translation>
        </message>
        <message>
            <source>{process} has no kerf and no power to test</source>
            <translation>{process} não tem largura do corte nem potência para testar</translation>
        </message>
        <message>
            <source>{process} is lowered and lifted, but the machine has no Z</source>
            <translation>{process} baixa e levanta a ferramenta, mas a máquina não tem Z</translation>
        </message>
        <message>
            <source>{process} takes no cut chart</source>
            <translation>{process} não usa tabela de corte</translation>
        </message>
        <message>
            <source>{program}, which is to be run before it, is refused</source>
            <translation>{program}, que deve ser executado antes, é recusado</translation>
        </message>
        <message>
            <source>{python} cannot be started: {error}</source>
            <translation>{python} não pode ser iniciado: {error}</translation>
        </message>
        <message>
            <source>{says} is larger than the tool</source>
            <translation>{says} é maior que a ferramenta</translation>
        </message>
        <message>
            <source>{says} is no number</source>
            <translation>{says} não é um número</translation>
        </message>
        <message>
            <source>{says} is out of range</source>
            <translation>{says} está fora de seus limites</translation>
        </message>
        <message>
            <source>{scrap_mm:.2f} mm of scrap there</source>
            <translation>{scrap_mm:.2f} mm de sobra ali</translation>
        </message>
        <message>
            <source>{skipped} other things</source>
            <translation>{skipped} outras coisas</translation>
        </message>
        <message>
            <source>{skipped} other things, the first: {why}</source>
            <translation>{skipped} outros elementos, o primeiro: {why}</translation>
        </message>
        <message>
            <source>{stale} has changed since the program was made</source>
            <translation>{stale} mudou desde que o programa foi feito</translation>
        </message>
        <message>
            <source>{state} at work {work}, machine {machine} mm, {moment}</source>
            <translation>{state} na peça em {work}, na máquina em {machine} mm, {moment}</translation>
        </message>
        <message>
            <source>{state}; it runs on for {left_s:.0f} s</source>
            <translation>{state}; ela continua por {left_s:.0f} s</translation>
        </message>
        <message>
            <source>{style} does not drill in pecks</source>
            <translation>{style} não fura com bicadas</translation>
        </message>
        <message>
            <source>{style} does not wait at the bottom</source>
            <translation>{style} não espera no fundo</translation>
        </message>
        <message>
            <source>{style} drills in pecks and needs peck_mm</source>
            <translation>{style} fura com bicadas e precisa de peck_mm</translation>
        </message>
        <message>
            <source>{style} waits at the bottom and needs dwell_s</source>
            <translation>{style} espera no fundo e precisa de dwell_s</translation>
        </message>
        <message>
            <source>{system} is not the work system in force</source>
            <translation>{system} não é o sistema de coordenadas em vigor</translation>
        </message>
        <message>
            <source>{thick_mm:.3f} mm ({area_mm2:.3f} mm²) at X{x:.2f} Y{y:.2f}</source>
            <translation>{thick_mm:.3f} mm ({area_mm2:.3f} mm²) em X{x:.2f} Y{y:.2f}</translation>
        </message>
        <message>
            <source>{title} blunts tools of HSS at once</source>
            <translation>{title} cega ferramentas de aço rápido de imediato</translation>
        </message>
        <message>
            <source>{twice} curve(s) are drawn twice and are cut once</source>
            <translation>{twice} curva(s) desenhada(s) duas vezes: o corte é feito uma só vez</translation>
        </message>
        <message>
            <source>{twice} of the {drawn} holes are at the place of others and are made once</source>
            <translation>{twice} dos {drawn} furos ficam onde outros estão e são feitos uma só vez</translation>
        </message>
        <message>
            <source>{unreachable_mm:.3f} mm of material stays at each end of the long axis, where the ellipse is tighter than the tool; a tool of at most {short_mm:.3g} mm diameter reaches it</source>
            <translation>{unreachable_mm:.3f} mm de material ficam em cada ponta do eixo maior, onde a elipse é mais fechada que a ferramenta; uma ferramenta de no máximo {short_mm:.3g} mm de diâmetro alcança</translation>
        </message>
        <message>
            <source>{untaken} chains</source>
            <translation>{untaken} cadeias</translation>
        </message>
        <message>
            <source>{user} and {user2} would both use the axis words</source>
            <translation>{user} e {user2} usariam os dois as palavras de eixo</translation>
        </message>
        <message>
            <source>{value:g} must be a whole number</source>
            <translation>{value:g} está onde deve haver um número inteiro</translation>
        </message>
        <message>
            <source>{wall_mm:g} mm radius</source>
            <translation>raio de {wall_mm:g} mm</translation>
        </message>
        <message>
            <source>{what} cannot be sent to a controller of this computer</source>
            <translation>{what} não pode ser enviado a um controlador deste computador</translation>
        </message>
        <message>
            <source>{what} must be larger than {than}</source>
            <translation>{what}: deve ser maior que {than}</translation>
        </message>
        <message>
            <source>{what} while the tool is compensated</source>
            <translation>{what} enquanto a ferramenta é compensada</translation>
        </message>
        <message>
            <source>{what}, not {value}</source>
            <translation>{what}, não {value}</translation>
        </message>
        <message>
            <source>{why}. Now {state}</source>
            <translation>{why}. Agora {state}</translation>
        </message>
        <message>
            <source>{width_mm:.2f} mm from {begin_mm:.2f} mm on</source>
            <translation>{width_mm:.2f} mm a partir de {begin_mm:.2f} mm</translation>
        </message>
        <message>
            <source>{width_mm:g} mm wide</source>
            <translation>{width_mm:g} mm de largura</translation>
        </message>
        <message>
            <source>{width} by {height}</source>
            <translation>{width} por {height}</translation>
        </message>
        <message>
            <source>{word} by the button on {button}</source>
            <translation>{word} pelo botão em {button}</translation>
        </message>
        <message>
            <source>{word} is in force, wanted {wanted}</source>
            <translation>{word} está em vigor, mas deveria ser {wanted}</translation>
        </message>
        <message>
            <source>{xy} points, {bulge} bulges</source>
            <translation>{xy} pontos, {bulge} bulges</translation>
        </message>
        <message>
            <source>~ is a command to the controller (cycle start), not part of a program</source>
            <translation>~ é um comando para o controlador (iniciar ciclo), não faz parte de um programa</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Bore</name>
        <message>
            <source>Bore</source>
            <translation>Mandrilar</translation>
        </message>
        <message>
            <source>Cuts holes wider than the tool along helices: the selected circles</source>
            <translation>Corta furos mais largos que a ferramenta em hélices: os círculos selecionados</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_CircularPocket</name>
        <message>
            <source>Circular pocket</source>
            <translation>Bolsão circular</translation>
        </message>
        <message>
            <source>Cuts a pocket: the selected circle, or one by numbers</source>
            <translation>Corta um bolsão: o círculo selecionado ou um por números</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Contour</name>
        <message>
            <source>Contour</source>
            <translation>Contorno</translation>
        </message>
        <message>
            <source>Cuts along the selected lines or faces: outside, inside or on</source>
            <translation>Corta ao longo das linhas ou faces selecionadas: por fora, por dentro ou sobre elas</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Controller</name>
        <message>
            <source>Controller</source>
            <translation>Controlador</translation>
        </message>
        <message>
            <source>Shows the machine: state, position, hold, stop, jog, zero</source>
            <translation>Mostra a máquina: estado, posição, pausar, parar, movimento manual, zero</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Drill</name>
        <message>
            <source>Drill</source>
            <translation>Furar</translation>
        </message>
        <message>
            <source>Drills at the selected circles and points, or in a pattern</source>
            <translation>Fura nos círculos e pontos selecionados ou em um padrão</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Duplicate</name>
        <message>
            <source>Duplicate</source>
            <translation>Duplicar</translation>
        </message>
        <message>
            <source>Puts a copy of each selected operation behind it in the job</source>
            <translation>Põe uma cópia de cada operação selecionada logo depois dela no trabalho</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_EditProgram</name>
        <message>
            <source>Edit program</source>
            <translation>Editar programa</translation>
        </message>
        <message>
            <source>Opens the program of the job in the editor</source>
            <translation>Abre o programa do trabalho no editor</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_EllipticalPocket</name>
        <message>
            <source>Cuts a pocket: the selected ellipse, or one by numbers</source>
            <translation>Usina um bolsão: a elipse selecionada, ou uma por números</translation>
        </message>
        <message>
            <source>Elliptical pocket</source>
            <translation>Bolsão elíptico</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Engrave</name>
        <message>
            <source>Cuts along the lines of the selected drawing</source>
            <translation>Usina ao longo das linhas do desenho selecionado</translation>
        </message>
        <message>
            <source>Engrave</source>
            <translation>Gravar</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_ExportJob</name>
        <message>
            <source>Export job…</source>
            <translation>Exportar trabalho…</translation>
        </message>
        <message>
            <source>Writes the job as a file that cncstepper runs</source>
            <translation>Grava o trabalho como um arquivo que o cncstepper executa</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Face</name>
        <message>
            <source>Face</source>
            <translation>Facear</translation>
        </message>
        <message>
            <source>Makes the top flat: of the stock, or of what is selected</source>
            <translation>Aplaina o topo: do bloco ou do que está selecionado</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Freehand</name>
        <message>
            <source>Draws a line with the mouse: press, move, release</source>
            <translation>Desenha uma linha com o mouse: pressione, mova, solte</translation>
        </message>
        <message>
            <source>Freehand</source>
            <translation>À mão livre</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_ImportDrawing</name>
        <message>
            <source>Brings in SVG, DXF, STEP, STL, pictures, points or G-code, linked to the file</source>
            <translation>Traz SVG, DXF, STEP, STL, imagens, pontos ou código G, ligados ao arquivo</translation>
        </message>
        <message>
            <source>Import drawing…</source>
            <translation>Importar desenho…</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_ImportTools</name>
        <message>
            <source>Adds the tools of FreeCAD's library or of a tool table</source>
            <translation>Adiciona as ferramentas da biblioteca do FreeCAD ou de uma tabela de ferramentas</translation>
        </message>
        <message>
            <source>Import tools…</source>
            <translation>Importar ferramentas…</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Letters</name>
        <message>
            <source>Draws a file of pulse letters and sends it, forwards and back</source>
            <translation>Desenha um arquivo de letras de pulso e o envia, para a frente e de volta</translation>
        </message>
        <message>
            <source>Pulse letters…</source>
            <translation>Letras de pulso…</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Machines</name>
        <message>
            <source>Machines…</source>
            <translation>Máquinas…</translation>
        </message>
        <message>
            <source>Makes and changes machine profiles, and tests a machine</source>
            <translation>Faz e muda perfis de máquina, e testa uma máquina</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_MoveDown</name>
        <message>
            <source>Cuts the selected operations after the one below them</source>
            <translation>Usina as operações selecionadas depois da que está abaixo delas</translation>
        </message>
        <message>
            <source>Move down</source>
            <translation>Mover para baixo</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_MoveUp</name>
        <message>
            <source>Cuts the selected operations before the one above them</source>
            <translation>Usina as operações selecionadas antes da que está acima delas</translation>
        </message>
        <message>
            <source>Move up</source>
            <translation>Mover para cima</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_NewJob</name>
        <message>
            <source>Makes a job. A selected solid or drawing gives its stock</source>
            <translation>Cria um trabalho. Um sólido ou desenho selecionado define o bloco</translation>
        </message>
        <message>
            <source>New job</source>
            <translation>Novo trabalho</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_OpenJob</name>
        <message>
            <source>Open job…</source>
            <translation>Abrir trabalho…</translation>
        </message>
        <message>
            <source>Opens a job file with its tools, operations and curves</source>
            <translation>Abre um arquivo de trabalho com suas ferramentas, operações e curvas</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_OpenProgram</name>
        <message>
            <source>Open G-code file…</source>
            <translation>Abrir arquivo G-code…</translation>
        </message>
        <message>
            <source>Opens a G-code file in the editor</source>
            <translation>Abre um arquivo G-code no editor</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Pocket</name>
        <message>
            <source>Clears what the selected closed lines or faces enclose</source>
            <translation>Esvazia o que as linhas fechadas ou faces selecionadas encerram</translation>
        </message>
        <message>
            <source>Pocket</source>
            <translation>Bolsão</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_RectangularPocket</name>
        <message>
            <source>Cuts a pocket: the selected rectangle, or one by numbers</source>
            <translation>Corta um bolsão: o retângulo selecionado ou um por números</translation>
        </message>
        <message>
            <source>Rectangular pocket</source>
            <translation>Bolsão retangular</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Send</name>
        <message>
            <source>Checks the program of the job and streams it to the machine</source>
            <translation>Verifica o programa do trabalho e o transmite à máquina</translation>
        </message>
        <message>
            <source>Send</source>
            <translation>Enviar</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Shapes</name>
        <message>
            <source>Adds a shape by its dimensions: holes, slots, flanges, brackets</source>
            <translation>Insere uma forma por suas dimensões: furos, rasgos, flanges, suportes</translation>
        </message>
        <message>
            <source>Shapes…</source>
            <translation>Formas…</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_SheetCut</name>
        <message>
            <source>Cuts parts out of sheet by torch, laser, jet, knife or point</source>
            <translation>Corta peças de uma chapa com tocha, laser, jato, faca ou ponta</translation>
        </message>
        <message>
            <source>Sheet cut</source>
            <translation>Corte de chapa</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Simulate</name>
        <message>
            <source>Check and simulate</source>
            <translation>Verificar e simular</translation>
        </message>
        <message>
            <source>Checks the program of the job and shows what it cuts</source>
            <translation>Verifica o programa do trabalho e mostra o que ele usina</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Text</name>
        <message>
            <source>Adds a text in any font, or in single lines for engraving</source>
            <translation>Insere um texto em qualquer fonte, ou em linhas únicas para gravar</translation>
        </message>
        <message>
            <source>Text</source>
            <translation>Texto</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Thread</name>
        <message>
            <source>Mills threads at the selected circles, or in a pattern</source>
            <translation>Fresa roscas nos círculos selecionados ou em um padrão</translation>
        </message>
        <message>
            <source>Thread</source>
            <translation>Rosquear</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_WireCut</name>
        <message>
            <source>Cuts parts out of foam with a hot wire, in from the edge</source>
            <translation>Corta peças de espuma com fio quente, a partir da borda</translation>
        </message>
        <message>
            <source>Wire cut</source>
            <translation>Corte com fio</translation>
        </message>
    </context>
</TS>
