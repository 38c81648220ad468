<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_BR" sourcelanguage="en">
    <context>
        <name>App::Property</name>
        <message>
            <source>A shipped profile's name, or a profile's file</source>
            <translation>O nome de um perfil fornecido, ou o arquivo de um perfil</translation>
        </message>
        <message>
            <source>A sketch or wire that holds one ellipse; without it the numbers count</source>
            <translation>Um esboço ou arame com uma elipse; sem ele valem os números</translation>
        </message>
        <message>
            <source>Active</source>
            <translation>Ativa</translation>
        </message>
        <message>
            <source>Arcs within a tolerance, or the published points</source>
            <translation>Arcos dentro de uma tolerância, ou os pontos publicados</translation>
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
            <source>Centre</source>
            <translation>Centro</translation>
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
            <source>Closed</source>
            <translation>Fechada</translation>
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
            <source>Corner Radius</source>
            <translation>Raio de canto</translation>
        </message>
        <message>
            <source>Corner radius</source>
            <translation>Raio de canto</translation>
        </message>
        <message>
            <source>Cut</source>
            <translation>Corte</translation>
        </message>
        <message>
            <source>Cutting</source>
            <translation>Corte</translation>
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
            <source>Dialect</source>
            <translation>Dialeto</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>Diâmetro</translation>
        </message>
        <message>
            <source>Direction</source>
            <translation>Sentido</translation>
        </message>
        <message>
            <source>Drawing</source>
            <translation>Desenho</translation>
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
            <source>Engagement Max</source>
            <translation>Ângulo de contato máximo</translation>
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
            <source>Entry angle</source>
            <translation>Ângulo de entrada</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>Avanço</translation>
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
            <source>From X to the ellipse's first axis</source>
            <translation>De X até o primeiro eixo da elipse</translation>
        </message>
        <message>
            <source>From here down the tool feeds</source>
            <translation>Daqui para baixo a ferramenta avança em velocidade de corte</translation>
        </message>
        <message>
            <source>From the tip to the holder; 0: not given</source>
            <translation>Da ponta ao porta-ferramenta; 0: não informado</translation>
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
            <source>How far from the stock's edge cuts must stay; 0: the edge does not matter</source>
            <translation>A que distância da borda do bloco os cortes devem ficar; 0: a borda não importa</translation>
        </message>
        <message>
            <source>How far the path may be off an ellipse or a B-spline; lines and arcs are exact</source>
            <translation>Quanto a trajetória pode desviar de uma elipse ou B-spline; retas e arcos são exatos</translation>
        </message>
        <message>
            <source>How far the wall may be off the ellipse</source>
            <translation>Quanto a parede pode desviar da elipse</translation>
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
            <source>How many teeth; 0: not given</source>
            <translation>Quantos dentes; 0: não informado</translation>
        </message>
        <message>
            <source>How much of the rim may be in the material, as an angle; 0: not given</source>
            <translation>Quanto do contorno pode estar no material, em ângulo; 0: não informado</translation>
        </message>
        <message>
            <source>How steeply a helix or ramp goes down</source>
            <translation>Inclinação com que a hélice ou rampa desce</translation>
        </message>
        <message>
            <source>How the cutter turns against the feed</source>
            <translation>Como a fresa gira em relação ao avanço</translation>
        </message>
        <message>
            <source>How the tool goes down</source>
            <translation>Como a ferramenta desce</translation>
        </message>
        <message>
            <source>Job</source>
            <translation>Trabalho</translation>
        </message>
        <message>
            <source>Kept</source>
            <translation>Pontos mantidos</translation>
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
            <source>Least chip load</source>
            <translation>Avanço por dente mínimo</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>Comprimento livre</translation>
        </message>
        <message>
            <source>Length, width and height; of a cylinder, which stands, the length is its diameter</source>
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
            <source>Line</source>
            <translation>Linha</translation>
        </message>
        <message>
            <source>Line Length</source>
            <translation>Comprimento das linhas</translation>
        </message>
        <message>
            <source>Line length</source>
            <translation>Comprimento das linhas</translation>
        </message>
        <message>
            <source>Lines</source>
            <translation>Linhas</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>Máquina</translation>
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
            <source>Number</source>
            <translation>Número</translation>
        </message>
        <message>
            <source>Of a bull nose; 0: not given</source>
            <translation>De uma fresa toroidal; 0: não informado</translation>
        </message>
        <message>
            <source>Of one wall that a jet or wire leaves, against the vertical; 0: none</source>
            <translation>De uma parede deixada pelo jato ou fio, em relação à vertical; 0: nenhuma</translation>
        </message>
        <message>
            <source>Of the written program</source>
            <translation>Do programa gerado</translation>
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
            <source>Outlines of the clamps</source>
            <translation>Contornos dos grampos</translation>
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
            <source>Plunge</source>
            <translation>Mergulho</translation>
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
            <source>Preview</source>
            <translation>Prévia</translation>
        </message>
        <message>
            <source>Problem</source>
            <translation>Problema</translation>
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
            <source>Radius X</source>
            <translation>Semieixo X</translation>
        </message>
        <message>
            <source>Radius Y</source>
            <translation>Semieixo Y</translation>
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
            <source>Ramp Max</source>
            <translation>Rampa máxima</translation>
        </message>
        <message>
            <source>Recalculated to whole passes</source>
            <translation>Em passes inteiros</translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation>Resolução</translation>
        </message>
        <message>
            <source>Retract</source>
            <translation>Retração</translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation>Rotação</translation>
        </message>
        <message>
            <source>Shape</source>
            <translation>Forma</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Tamanho</translation>
        </message>
        <message>
            <source>Solids that hold the work down, which the tool must not touch</source>
            <translation>Sólidos que prendem a peça e em que a ferramenta não pode tocar</translation>
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
            <source>Spindle turns a minute</source>
            <translation>Rotações do spindle por minuto</translation>
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
            <source>Taper</source>
            <translation>Conicidade</translation>
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
            <source>The clamps seen from above, at the height of their tops</source>
            <translation>Os grampos vistos de cima, na altura dos seus topos</translation>
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
            <source>The depth of the pocket, ap_total</source>
            <translation>A profundidade do bolsão, ap_total</translation>
        </message>
        <message>
            <source>The diameter of the cutter</source>
            <translation>O diâmetro da fresa</translation>
        </message>
        <message>
            <source>The diameter of what holds the tool; 0: not given</source>
            <translation>O diâmetro do que segura a ferramenta; 0: não informado</translation>
        </message>
        <message>
            <source>The drawing it followed, when that was deleted</source>
            <translation>O desenho que ela seguia, se foi excluído</translation>
        </message>
        <message>
            <source>The feed of the last pass at the wall; 0: the tool's own feed</source>
            <translation>O avanço do último passe na parede; 0: o avanço da própria ferramenta</translation>
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
            <source>The job whose program is shown</source>
            <translation>O trabalho cujo programa é mostrado</translation>
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
            <source>The length of all lines</source>
            <translation>O comprimento de todas as linhas</translation>
        </message>
        <message>
            <source>The length of the cutting edges; 0: not given</source>
            <translation>O comprimento das arestas de corte; 0: não informado</translation>
        </message>
        <message>
            <source>The middle of a mill's end that does not cut; 0: it cuts over its centre</source>
            <translation>O meio do topo da fresa que não corta; 0: ela tem corte no centro</translation>
        </message>
        <message>
            <source>The parts and bodies that the clamps move with</source>
            <translation>As peças e os corpos com que os grampos se movem</translation>
        </message>
        <message>
            <source>The parts and bodies that the drawing moves with</source>
            <translation>As peças e corpos com que o desenho se move</translation>
        </message>
        <message>
            <source>The points as they were drawn</source>
            <translation>Os pontos como foram desenhados</translation>
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
            <source>The sketch, wire, B-spline or freehand line to follow</source>
            <translation>O esboço, arame, B-spline ou linha à mão livre a seguir</translation>
        </message>
        <message>
            <source>The speed of cutting moves</source>
            <translation>A velocidade dos movimentos de corte</translation>
        </message>
        <message>
            <source>The speed straight down</source>
            <translation>A velocidade descendo na vertical</translation>
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
            <source>The width of one pass at most, ae</source>
            <translation>A largura máxima de um passe, ae</translation>
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
            <source>Tolerance</source>
            <translation>Tolerância</translation>
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
            <source>What is cut, in this order</source>
            <translation>O que é usinado, nesta ordem</translation>
        </message>
        <message>
            <source>What is switched on while cutting</source>
            <translation>O que fica ligado durante o corte</translation>
        </message>
        <message>
            <source>What the raw material looks like</source>
            <translation>Como é a matéria-prima</translation>
        </message>
        <message>
            <source>What the round tool must leave at the ends of the long axis</source>
            <translation>O que a ferramenta redonda deixa nas pontas do eixo maior</translation>
        </message>
        <message>
            <source>Where on the stock the work zero lies</source>
            <translation>Onde fica o zero-peça no bloco</translation>
        </message>
        <message>
            <source>Where rapids travel across the work</source>
            <translation>Altura dos movimentos rápidos sobre a peça</translation>
        </message>
        <message>
            <source>Where the work zero lies in this document</source>
            <translation>Onde fica o zero-peça neste documento</translation>
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
            <source>'{0}' is no value in {1}</source>
            <translation>'{0}' não é um valor em {1}</translation>
        </message>
        <message>
            <source>'{0}' is no whole number</source>
            <translation>'{0}' não é um número inteiro</translation>
        </message>
        <message>
            <source>'{0}' is too large</source>
            <translation>'{0}' é grande demais</translation>
        </message>
        <message>
            <source>A controller is connected already.</source>
            <translation>Um controlador já está conectado.</translation>
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
            <source>A machine's profile</source>
            <translation>Perfil de uma máquina</translation>
        </message>
        <message>
            <source>A profile's file…</source>
            <translation>Arquivo de perfil…</translation>
        </message>
        <message>
            <source>A serial port, or an address as socket://192.168.0.7:23</source>
            <translation>Uma porta serial, ou um endereço como socket://192.168.0.7:23</translation>
        </message>
        <message>
            <source>A shipped profile's name, or a profile's file</source>
            <translation>O nome de um perfil fornecido, ou o arquivo de um perfil</translation>
        </message>
        <message>
            <source>A sketch or wire that holds one ellipse; without it the numbers count</source>
            <translation>Um esboço ou arame com uma elipse; sem ele valem os números</translation>
        </message>
        <message>
            <source>A tool of this shape has none</source>
            <translation>Uma ferramenta desta forma não tem este valor</translation>
        </message>
        <message>
            <source>A value is missing here</source>
            <translation>Falta um valor aqui</translation>
        </message>
        <message>
            <source>Active</source>
            <translation>Ativa</translation>
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
            <source>Add the part, as it stands now, to the document as a mesh</source>
            <translation>Acrescentar ao documento, como malha, a peça tal como está agora</translation>
        </message>
        <message>
            <source>Add tool</source>
            <translation>Adicionar</translation>
        </message>
        <message>
            <source>Alarm</source>
            <translation>Alarme</translation>
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
            <source>An expression gives this value; change it in the property editor</source>
            <translation>Uma expressão define este valor; altere-o no editor de propriedades</translation>
        </message>
        <message>
            <source>Another machine?</source>
            <translation>Outra máquina?</translation>
        </message>
        <message>
            <source>Arcs within a tolerance, or the published points</source>
            <translation>Arcos dentro de uma tolerância, ou os pontos publicados</translation>
        </message>
        <message>
            <source>Attached again to the controller at {0}.</source>
            <translation>Reconectado ao controlador em {0}.</translation>
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
            <source>Busy</source>
            <translation>Ocupado</translation>
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
            <source>Change the programmed value while cutting, in percent.</source>
            <translation>Ajusta o valor programado durante o corte, em porcento.</translation>
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
            <source>Choose one here</source>
            <translation>Escolha aqui</translation>
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
            <source>Connecting…</source>
            <translation>Conectando…</translation>
        </message>
        <message>
            <source>Connection lost</source>
            <translation>Conexão perdida</translation>
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
            <source>Controller</source>
            <translation>Controlador</translation>
        </message>
        <message>
            <source>Coolant</source>
            <translation>Refrigeração</translation>
        </message>
        <message>
            <source>Core diameter</source>
            <translation>Diâmetro do núcleo</translation>
        </message>
        <message>
            <source>Corner radius</source>
            <translation>Raio de canto</translation>
        </message>
        <message>
            <source>Cut</source>
            <translation>Corte</translation>
        </message>
        <message>
            <source>Cut in this order; what is not checked is left out of the program</source>
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
            <source>Cutting</source>
            <translation>Corte</translation>
        </message>
        <message>
            <source>Cutting the part…</source>
            <translation>Usinando a peça…</translation>
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
            <source>Direction</source>
            <translation>Sentido</translation>
        </message>
        <message>
            <source>Disconnect</source>
            <translation>Desconectar</translation>
        </message>
        <message>
            <source>Disconnect first: this is what the dock is connected to.</source>
            <translation>Desconecte antes: é a isto que o painel está conectado.</translation>
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
            <source>Drag a point to move it, the line to add one; Delete takes the point under the pointer. Esc: done.</source>
            <translation>Arraste um ponto para movê-lo, a linha para adicionar um; Delete exclui o ponto sob o cursor. Esc: terminar.</translation>
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
            <source>Edit {0}</source>
            <translation>Editar {0}</translation>
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
            <source>Engraving</source>
            <translation>Gravação</translation>
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
            <source>Error</source>
            <translation>Erro</translation>
        </message>
        <message>
            <source>Failed</source>
            <translation>Falhou</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>Avanço</translation>
        </message>
        <message>
            <source>Feeding in air</source>
            <translation>Avanço no ar</translation>
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
            <source>Finish</source>
            <translation>Acabamento</translation>
        </message>
        <message>
            <source>Finishing</source>
            <translation>Terminando</translation>
        </message>
        <message>
            <source>Fit to drawing</source>
            <translation>Ajustar ao desenho</translation>
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
            <source>Follow the drawing that is selected in the tree or in the 3D view</source>
            <translation>Seguir o desenho selecionado na árvore ou na vista 3D</translation>
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
            <source>FreeCAD's Python lacks numba. All works without, but planning and simulating are slow.</source>
            <translation>Falta numba no Python do FreeCAD. Tudo funciona sem ele, mas o planejamento e a simulação ficam lentos.</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks pyserial. No machine can be reached without.</source>
            <translation>Falta pyserial no Python do FreeCAD. Sem ele não se alcança nenhuma máquina.</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}</source>
            <translation>Falta no Python do FreeCAD: {0}</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}. No program can be made without.</source>
            <translation>Falta no Python do FreeCAD: {0}. Sem isso não é possível gerar programas.</translation>
        </message>
        <message>
            <source>From X to the ellipse's first axis</source>
            <translation>De X até o primeiro eixo da elipse</translation>
        </message>
        <message>
            <source>From here down the tool feeds</source>
            <translation>Daqui para baixo a ferramenta avança em velocidade de corte</translation>
        </message>
        <message>
            <source>From the tip to the holder; 0: not given</source>
            <translation>Da ponta ao porta-ferramenta; 0: não informado</translation>
        </message>
        <message>
            <source>Go on</source>
            <translation>Continuar</translation>
        </message>
        <message>
            <source>Go on after a hold, a pause or the door.</source>
            <translation>Continua após uma pausa, uma espera ou a porta.</translation>
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
            <source>Height above the top of the stock; lines: where the tool's tip goes</source>
            <translation>Altura acima do topo do bloco; linhas: por onde passa a ponta da ferramenta</translation>
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
            <source>Hold</source>
            <translation>Pausar</translation>
        </message>
        <message>
            <source>Hold: slow down and stand still; nothing is lost, the spindle goes on turning.</source>
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
            <source>Home</source>
            <translation>Referenciar</translation>
        </message>
        <message>
            <source>Homing</source>
            <translation>Referenciando</translation>
        </message>
        <message>
            <source>Homing works only while the machine is idle or in alarm.</source>
            <translation>Só é possível referenciar com a máquina pronta ou em alarme.</translation>
        </message>
        <message>
            <source>How far from the stock's edge cuts must stay; 0: the edge does not matter</source>
            <translation>A que distância da borda do bloco os cortes devem ficar; 0: a borda não importa</translation>
        </message>
        <message>
            <source>How far one click moves the machine.</source>
            <translation>Quanto um clique move a máquina.</translation>
        </message>
        <message>
            <source>How far the path may be off an ellipse or a B-spline; lines and arcs are exact</source>
            <translation>Quanto a trajetória pode desviar de uma elipse ou B-spline; retas e arcos são exatos</translation>
        </message>
        <message>
            <source>How far the wall may be off the ellipse</source>
            <translation>Quanto a parede pode desviar da elipse</translation>
        </message>
        <message>
            <source>How fast the machine moves while jogging; it never goes faster than it can.</source>
            <translation>Velocidade da máquina no movimento manual; nunca acima do que ela pode.</translation>
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
            <source>How many teeth; 0: not given</source>
            <translation>Quantos dentes; 0: não informado</translation>
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
            <source>How much of the rim may be in the material, as an angle; 0: not given</source>
            <translation>Quanto do contorno pode estar no material, em ângulo; 0: não informado</translation>
        </message>
        <message>
            <source>How steeply a helix or ramp goes down</source>
            <translation>Inclinação com que a hélice ou rampa desce</translation>
        </message>
        <message>
            <source>How the cutter turns against the feed</source>
            <translation>Como a fresa gira em relação ao avanço</translation>
        </message>
        <message>
            <source>How the tool goes down</source>
            <translation>Como a ferramenta desce</translation>
        </message>
        <message>
            <source>Idle</source>
            <translation>Pronta</translation>
        </message>
        <message>
            <source>Is the work zero set on the stock and the way free?</source>
            <translation>O zero-peça está definido no bloco e o caminho está livre?</translation>
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
            <source>Least chip load</source>
            <translation>Avanço por dente mínimo</translation>
        </message>
        <message>
            <source>Leave out of the program</source>
            <translation>Deixar fora do programa</translation>
        </message>
        <message>
            <source>Length, width and height; of a cylinder, which stands, the length is its diameter</source>
            <translation>Comprimento, largura e altura; num cilindro, que fica em pé, o comprimento é o diâmetro</translation>
        </message>
        <message>
            <source>Lengths and limits</source>
            <translation>Comprimentos e limites</translation>
        </message>
        <message>
            <source>Let go of the controller.</source>
            <translation>Libera o controlador.</translation>
        </message>
        <message>
            <source>Let the machine find its own zero with its switches.</source>
            <translation>Deixa a máquina encontrar o próprio zero com os fins de curso.</translation>
        </message>
        <message>
            <source>Levels</source>
            <translation>Níveis</translation>
        </message>
        <message>
            <source>Line</source>
            <translation>Linha</translation>
        </message>
        <message>
            <source>Line length</source>
            <translation>Comprimento das linhas</translation>
        </message>
        <message>
            <source>Lines</source>
            <translation>Linhas</translation>
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
            <source>Looking for a Python…</source>
            <translation>Procurando um Python…</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>Máquina</translation>
        </message>
        <message>
            <source>Make a job first, with New job</source>
            <translation>Crie antes um trabalho, com Novo trabalho</translation>
        </message>
        <message>
            <source>Make this position the work zero of the axis.</source>
            <translation>Faz desta posição o zero-peça do eixo.</translation>
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
            <source>Motor steps: {0}</source>
            <translation>Passos dos motores: {0}</translation>
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
            <source>Move the machine in this direction.</source>
            <translation>Move a máquina neste sentido.</translation>
        </message>
        <message>
            <source>New job</source>
            <translation>Novo trabalho</translation>
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
            <source>No messages yet</source>
            <translation>Nenhuma mensagem ainda</translation>
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
            <source>Note</source>
            <translation>Observação</translation>
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
            <source>Number</source>
            <translation>Número</translation>
        </message>
        <message>
            <source>Of a bull nose; 0: not given</source>
            <translation>De uma fresa toroidal; 0: não informado</translation>
        </message>
        <message>
            <source>Of one wall that a jet or wire leaves, against the vertical; 0: none</source>
            <translation>De uma parede deixada pelo jato ou fio, em relação à vertical; 0: nenhuma</translation>
        </message>
        <message>
            <source>Of the written program</source>
            <translation>Do programa gerado</translation>
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
            <source>Open or make a document first</source>
            <translation>Abra ou crie antes um documento</translation>
        </message>
        <message>
            <source>Open the 3D view of the document first</source>
            <translation>Abra antes a vista 3D do documento</translation>
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
            <source>Outlines of the clamps</source>
            <translation>Contornos dos grampos</translation>
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
            <source>Passes</source>
            <translation>Passes</translation>
        </message>
        <message>
            <source>Path</source>
            <translation>Trajetória</translation>
        </message>
        <message>
            <source>Paused</source>
            <translation>Em espera</translation>
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
            <source>Port</source>
            <translation>Porta</translation>
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
            <source>Programs ({0})</source>
            <translation>Programas ({0})</translation>
        </message>
        <message>
            <source>Pulse</source>
            <translation>Pulso</translation>
        </message>
        <message>
            <source>Put the stock around what is selected, or around the drawings of the operations</source>
            <translation>Põe o bloco em torno do que está selecionado, ou dos desenhos das operações</translation>
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
            <source>Rapid</source>
            <translation>Rápido</translation>
        </message>
        <message>
            <source>Rapids</source>
            <translation>Rápidos</translation>
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
            <source>Recalculated to whole passes</source>
            <translation>Em passes inteiros</translation>
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
            <source>Release to close the line. Esc: give up this line.</source>
            <translation>Solte para fechar a linha. Esc: desistir desta linha.</translation>
        </message>
        <message>
            <source>Release: done. Release at the start: close the line. Shift: straight. Esc: give up this line.</source>
            <translation>Soltar: pronto. Soltar no início: fechar a linha. Shift: reta. Esc: desistir desta linha.</translation>
        </message>
        <message>
            <source>Remaining</source>
            <translation>Restante</translation>
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
            <source>Resolution</source>
            <translation>Resolução</translation>
        </message>
        <message>
            <source>Resume</source>
            <translation>Retomar</translation>
        </message>
        <message>
            <source>Retract</source>
            <translation>Retração</translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation>Rotação</translation>
        </message>
        <message>
            <source>Running</source>
            <translation>Usinando</translation>
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
            <source>Select a drawing in the tree or in the 3D view first</source>
            <translation>Selecione antes um desenho na árvore ou na vista 3D</translation>
        </message>
        <message>
            <source>Select a drawing or a solid first</source>
            <translation>Selecione antes um desenho ou um sólido</translation>
        </message>
        <message>
            <source>Select one or more solids first</source>
            <translation>Selecione antes um ou mais sólidos</translation>
        </message>
        <message>
            <source>Select the job in the tree: this document has several</source>
            <translation>Selecione o trabalho na árvore: este documento tem vários</translation>
        </message>
        <message>
            <source>Select what is to be engraved: a sketch, a wire, a B-spline or a freehand line</source>
            <translation>Selecione o que será gravado: um esboço, um arame, uma B-spline ou uma linha à mão livre</translation>
        </message>
        <message>
            <source>Send anyway</source>
            <translation>Enviar assim mesmo</translation>
        </message>
        <message>
            <source>Shape</source>
            <translation>Forma</translation>
        </message>
        <message>
            <source>Show the tool's path</source>
            <translation>Mostra a trajetória da ferramenta</translation>
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
            <source>Solids that hold the work down, which the tool must not touch</source>
            <translation>Sólidos que prendem a peça e em que a ferramenta não pode tocar</translation>
        </message>
        <message>
            <source>Solids that the tool must not touch; findings name them by their number</source>
            <translation>Sólidos em que a ferramenta não pode tocar; as ocorrências os citam pelo número</translation>
        </message>
        <message>
            <source>Speed</source>
            <translation>Velocidade</translation>
        </message>
        <message>
            <source>Spindle</source>
            <translation>Spindle</translation>
        </message>
        <message>
            <source>Spindle turns a minute</source>
            <translation>Rotações do spindle por minuto</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Iniciar</translation>
        </message>
        <message>
            <source>Starting</source>
            <translation>Iniciando</translation>
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
            <source>Stock</source>
            <translation>Bloco</translation>
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
            <source>Stop: slow down, stand still, spindle off; the rest of the job is not cut. This is not an emergency stop: the emergency stop is on the machine.</source>
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
            <source>Switch {0}</source>
            <translation>Alternar {0}</translation>
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
            <source>Take the alarm away without homing: only when the position is surely right.</source>
            <translation>Retira o alarme sem referenciar: só quando a posição está certa com certeza.</translation>
        </message>
        <message>
            <source>Take the solids that are selected for clamps</source>
            <translation>Usa como grampos os sólidos selecionados</translation>
        </message>
        <message>
            <source>Taper</source>
            <translation>Conicidade</translation>
        </message>
        <message>
            <source>The T word of the program</source>
            <translation>A palavra T do programa</translation>
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
            <source>The clamps seen from above, at the height of their tops</source>
            <translation>Os grampos vistos de cima, na altura dos seus topos</translation>
        </message>
        <message>
            <source>The connection is being made.</source>
            <translation>A conexão está sendo feita.</translation>
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
            <source>The cut goes on without FreeCAD; the controller's panel finds it again the next time it is opened.</source>
            <translation>O corte continua sem o FreeCAD; o painel do controlador o reencontra na próxima vez que for aberto.</translation>
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
            <source>The depth of the pocket, ap_total</source>
            <translation>A profundidade do bolsão, ap_total</translation>
        </message>
        <message>
            <source>The diameter of the cutter</source>
            <translation>O diâmetro da fresa</translation>
        </message>
        <message>
            <source>The diameter of what holds the tool; 0: not given</source>
            <translation>O diâmetro do que segura a ferramenta; 0: não informado</translation>
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
            <source>The feed of the last pass at the wall; 0: the tool's own feed</source>
            <translation>O avanço do último passe na parede; 0: o avanço da própria ferramenta</translation>
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
            <source>The job is being cut.</source>
            <translation>O trabalho está sendo usinado.</translation>
        </message>
        <message>
            <source>The job whose program is shown</source>
            <translation>O trabalho cujo programa é mostrado</translation>
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
            <source>The length of all lines</source>
            <translation>O comprimento de todas as linhas</translation>
        </message>
        <message>
            <source>The length of the cutting edges; 0: not given</source>
            <translation>O comprimento das arestas de corte; 0: não informado</translation>
        </message>
        <message>
            <source>The link to the controller is being started.</source>
            <translation>A ligação com o controlador está sendo iniciada.</translation>
        </message>
        <message>
            <source>The machine is cutting a job.</source>
            <translation>A máquina está usinando um trabalho.</translation>
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
            <source>The machine stands and waits.</source>
            <translation>A máquina está parada e à espera.</translation>
        </message>
        <message>
            <source>The machine stands; nothing is lost. Resume or stop.</source>
            <translation>A máquina está parada; nada se perdeu. Retome ou pare.</translation>
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
            <source>The parts and bodies that the clamps move with</source>
            <translation>As peças e os corpos com que os grampos se movem</translation>
        </message>
        <message>
            <source>The parts and bodies that the drawing moves with</source>
            <translation>As peças e corpos com que o desenho se move</translation>
        </message>
        <message>
            <source>The points as they were drawn</source>
            <translation>Os pontos como foram desenhados</translation>
        </message>
        <message>
            <source>The program has changed since: what is shown is the one before.</source>
            <translation>O programa mudou desde então: o que se vê é o anterior.</translation>
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
            <source>The program waits. Resume goes on.</source>
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
            <source>The sketch, wire, B-spline or freehand line to follow</source>
            <translation>O esboço, arame, B-spline ou linha à mão livre a seguir</translation>
        </message>
        <message>
            <source>The speed of cutting moves</source>
            <translation>A velocidade dos movimentos de corte</translation>
        </message>
        <message>
            <source>The speed straight down</source>
            <translation>A velocidade descendo na vertical</translation>
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
            <source>The width of one pass at most, ae</source>
            <translation>A largura máxima de um passe, ae</translation>
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
            <source>This machine has no homing switches set up ($22=0).</source>
            <translation>Esta máquina não tem fins de curso de referência configurados ($22=0).</translation>
        </message>
        <message>
            <source>This takes a number without a unit, not '{0}'</source>
            <translation>Aqui vai um número sem unidade, não '{0}'</translation>
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
            <source>Timing the moves…</source>
            <translation>Cronometrando os movimentos…</translation>
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
            <source>To get what is missing, type in a terminal, with Python {0}, and start FreeCAD again:</source>
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
            <source>Tolerance</source>
            <translation>Tolerância</translation>
        </message>
        <message>
            <source>Tool</source>
            <translation>Ferramenta</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Ferramentas</translation>
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
            <source>Unreachable</source>
            <translation>Inalcançável</translation>
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
            <source>What is cut, in this order</source>
            <translation>O que é usinado, nesta ordem</translation>
        </message>
        <message>
            <source>What is one step: a line of the program, a move, or a pulse of the motors</source>
            <translation>O que é um passo: uma linha do programa, um movimento ou um pulso dos motores</translation>
        </message>
        <message>
            <source>What is switched on while cutting</source>
            <translation>O que fica ligado durante o corte</translation>
        </message>
        <message>
            <source>What the raw material looks like</source>
            <translation>Como é a matéria-prima</translation>
        </message>
        <message>
            <source>What the round tool must leave at the ends of the long axis</source>
            <translation>O que a ferramenta redonda deixa nas pontas do eixo maior</translation>
        </message>
        <message>
            <source>Where on the stock the work zero lies</source>
            <translation>Onde fica o zero-peça no bloco</translation>
        </message>
        <message>
            <source>Where rapids travel across the work</source>
            <translation>Altura dos movimentos rápidos sobre a peça</translation>
        </message>
        <message>
            <source>Where the table stands is not known: home the machine, or set the work zero anew.</source>
            <translation>Não se sabe onde a mesa está: referencie a máquina ou defina de novo o zero-peça.</translation>
        </message>
        <message>
            <source>Where the work zero lies in this document</source>
            <translation>Onde fica o zero-peça neste documento</translation>
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
            <source>Work</source>
            <translation>Peça</translation>
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
            <source>Writing the report…</source>
            <translation>Escrevendo o relatório…</translation>
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
            <source>arcs within the tolerance</source>
            <translation>arcos dentro da tolerância</translation>
        </message>
        <message>
            <source>ball end mill</source>
            <translation>fresa de topo esférico</translation>
        </message>
        <message>
            <source>box</source>
            <translation>bloco</translation>
        </message>
        <message>
            <source>bull nose</source>
            <translation>fresa toroidal</translation>
        </message>
        <message>
            <source>centre of the top</source>
            <translation>centro do topo</translation>
        </message>
        <message>
            <source>climb</source>
            <translation>concordante</translation>
        </message>
        <message>
            <source>conventional</source>
            <translation>discordante</translation>
        </message>
        <message>
            <source>cylinder</source>
            <translation>cilindro</translation>
        </message>
        <message>
            <source>drill</source>
            <translation>broca</translation>
        </message>
        <message>
            <source>engraver</source>
            <translation>ferramenta de gravação</translation>
        </message>
        <message>
            <source>feed</source>
            <translation>avanço</translation>
        </message>
        <message>
            <source>flat end mill</source>
            <translation>fresa de topo reto</translation>
        </message>
        <message>
            <source>flood (M8)</source>
            <translation>jato (M8)</translation>
        </message>
        <message>
            <source>front left corner of the top</source>
            <translation>canto frontal esquerdo do topo</translation>
        </message>
        <message>
            <source>helix</source>
            <translation>hélice</translation>
        </message>
        <message>
            <source>inches (G20)</source>
            <translation>polegadas (G20)</translation>
        </message>
        <message>
            <source>jet (water, plasma, laser)</source>
            <translation>jato (água, plasma, laser)</translation>
        </message>
        <message>
            <source>limit {0}</source>
            <translation>limite {0}</translation>
        </message>
        <message>
            <source>make room in the folder for temporary files</source>
            <translation>libere espaço na pasta de arquivos temporários</translation>
        </message>
        <message>
            <source>millimetres (G21)</source>
            <translation>milímetros (G21)</translation>
        </message>
        <message>
            <source>mist (M7)</source>
            <translation>névoa (M7)</translation>
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
            <source>none</source>
            <translation>nenhuma</translation>
        </message>
        <message>
            <source>none yet</source>
            <translation>nenhum ainda</translation>
        </message>
        <message>
            <source>none, the numbers count</source>
            <translation>nenhum, valem os números</translation>
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
            <source>published points (DDA)</source>
            <translation>pontos publicados (DDA)</translation>
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
            <source>sheet</source>
            <translation>chapa</translation>
        </message>
        <message>
            <source>straight down</source>
            <translation>na vertical</translation>
        </message>
        <message>
            <source>the machine's own</source>
            <translation>o da máquina</translation>
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
            <source>value {0}</source>
            <translation>valor {0}</translation>
        </message>
        <message>
            <source>wire</source>
            <translation>fio</translation>
        </message>
        <message>
            <source>{0} %</source>
            <translation>{0} %</translation>
        </message>
        <message>
            <source>{0} = 0</source>
            <translation>{0} = 0</translation>
        </message>
        <message>
            <source>{0} has nothing to cut: add an operation</source>
            <translation>{0} não tem o que usinar: adicione uma operação</translation>
        </message>
        <message>
            <source>{0} is cut with it; choose another tool there first</source>
            <translation>{0} é usinada com ela; escolha antes outra ferramenta lá</translation>
        </message>
        <message>
            <source>{0} moves</source>
            <translation>{0} movimentos</translation>
        </message>
        <message>
            <source>{0} of {1} lines, line {2} of the file</source>
            <translation>{0} de {1} linhas, linha {2} do arquivo</translation>
        </message>
        <message>
            <source>{0} rpm</source>
            <translation>{0} rpm</translation>
        </message>
        <message>
            <source>{0} ×</source>
            <translation>{0} ×</translation>
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
            <source>{0}:</source>
            <translation>{0}:</translation>
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
    </context>
    <context>
        <name>CNCStepper core</name>
        <message>
            <source>${0} is {1}, wanted {2}</source>
            <translation>${0} é {1}, esperado {2}</translation>
        </message>
        <message>
            <source>'{0}' cannot be {1}</source>
            <translation>'{0}' não pode ser {1}</translation>
        </message>
        <message>
            <source>'{0}' is no origin of a stock</source>
            <translation>'{0}' não é uma origem de bloco</translation>
        </message>
        <message>
            <source>'{0}' is no solid and cannot be a clamp</source>
            <translation>'{0}' não é um sólido e não pode ser grampo</translation>
        </message>
        <message>
            <source>'{0}' is not a tool</source>
            <translation>'{0}' não é uma ferramenta</translation>
        </message>
        <message>
            <source>'{0}' names no axes</source>
            <translation>'{0}' não indica eixos</translation>
        </message>
        <message>
            <source>'{0}' names no port number</source>
            <translation>'{0}' não indica um número de porta</translation>
        </message>
        <message>
            <source>'{0}' stands on this job and cannot be its clamp</source>
            <translation>'{0}' depende deste trabalho e não pode ser grampo dele</translation>
        </message>
        <message>
            <source>0 to {0} mm</source>
            <translation>0 a {0} mm</translation>
        </message>
        <message>
            <source>CNCStepper certificate</source>
            <translation>certificado do CNCStepper</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}</source>
            <translation>Falta no Python do FreeCAD: {0}</translation>
        </message>
        <message>
            <source>G43.1 may move only the tool-length axis</source>
            <translation>G43.1 só pode mover o eixo do comprimento da ferramenta</translation>
        </message>
        <message>
            <source>G53 works only with G0 and G1</source>
            <translation>G53 só funciona com G0 e G1</translation>
        </message>
        <message>
            <source>Reset to continue</source>
            <translation>Reset to continue</translation>
        </message>
        <message>
            <source>a P or L value is missing</source>
            <translation>falta um valor P ou L</translation>
        </message>
        <message>
            <source>a bulge is not that of an arc in mm</source>
            <translation>um bulge não é o de um arco em mm</translation>
        </message>
        <message>
            <source>a chip load needs flutes</source>
            <translation>um avanço por dente precisa do número de dentes</translation>
        </message>
        <message>
            <source>a coordinate is not a length in mm</source>
            <translation>uma coordenada não é um comprimento em mm</translation>
        </message>
        <message>
            <source>a curve needs at least two points and a bulge for each segment</source>
            <translation>uma curva precisa de ao menos dois pontos e de um bulge por segmento</translation>
        </message>
        <message>
            <source>a cut goes into stock while the spindle stands</source>
            <translation>um corte entra no material com o spindle parado</translation>
        </message>
        <message>
            <source>a cutting move begins at an unknown position, so it is not checked against the stock</source>
            <translation>um movimento de corte começa em posição desconhecida, por isso não é verificado contra o bloco</translation>
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
            <source>a drill goes sideways through stock</source>
            <translation>uma broca anda de lado dentro do material</translation>
        </message>
        <message>
            <source>a height field needs two rows and two columns of finite heights at least</source>
            <translation>um campo de alturas precisa de ao menos duas linhas e duas colunas de alturas finitas</translation>
        </message>
        <message>
            <source>a job runs</source>
            <translation>um trabalho está em curso</translation>
        </message>
        <message>
            <source>a jog needs a way and a feed</source>
            <translation>um movimento manual precisa de distância e avanço</translation>
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
            <source>a mill that does not cut over its centre ({0}) goes down into stock too steeply</source>
            <translation>uma fresa sem corte no centro ({0}) desce no material com inclinação demais</translation>
        </message>
        <message>
            <source>a move would end outside the travel (soft limit)</source>
            <translation>um movimento terminaria fora do curso (limite de software)</translation>
        </message>
        <message>
            <source>a number is missing or cannot be read</source>
            <translation>um número falta ou não pode ser lido</translation>
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
            <source>a request without the session's token</source>
            <translation>um pedido sem a chave da sessão</translation>
        </message>
        <message>
            <source>a scale must be positive</source>
            <translation>uma escala deve ser positiva</translation>
        </message>
        <message>
            <source>a setting asks for more steps a second than the controller can give</source>
            <translation>uma configuração pede mais passos por segundo do que o controlador consegue</translation>
        </message>
        <message>
            <source>a tolerance must be above 0</source>
            <translation>uma tolerância deve ser maior que 0</translation>
        </message>
        <message>
            <source>a tooth of the {0} tool takes too thick a chip</source>
            <translation>um dente da ferramenta {0} tira um cavaco espesso demais</translation>
        </message>
        <message>
            <source>a value is negative where only positive ones are allowed</source>
            <translation>um valor é negativo onde só positivos são permitidos</translation>
        </message>
        <message>
            <source>a word does not begin with a letter</source>
            <translation>uma palavra não começa com letra</translation>
        </message>
        <message>
            <source>a word stands twice in one line</source>
            <translation>uma palavra aparece duas vezes na linha</translation>
        </message>
        <message>
            <source>a {0} tool has no {1}</source>
            <translation>uma ferramenta {0} não tem {1}</translation>
        </message>
        <message>
            <source>a {0} tool leaves no flat floor</source>
            <translation>uma ferramenta {0} não deixa o fundo plano</translation>
        </message>
        <message>
            <source>above 0 mm/min</source>
            <translation>acima de 0 mm/min</translation>
        </message>
        <message>
            <source>add the missing pass, or lower the stepover or the stepdown</source>
            <translation>acrescente o passe que falta, ou diminua a penetração de trabalho ou a profundidade de corte</translation>
        </message>
        <message>
            <source>add the tool or correct the T word</source>
            <translation>adicione a ferramenta ou corrija a palavra T</translation>
        </message>
        <message>
            <source>add yourself to its group (sudo usermod -aG dialout $USER) and log in again</source>
            <translation>entre no grupo dela (sudo usermod -aG dialout $USER) e faça login de novo</translation>
        </message>
        <message>
            <source>all {0} lines are cut, the machine is idle</source>
            <translation>todas as {0} linhas foram usinadas, a máquina está pronta</translation>
        </message>
        <message>
            <source>an offset came damaged: {0}</source>
            <translation>um deslocamento chegou danificado: {0}</translation>
        </message>
        <message>
            <source>another task is open in the task panel</source>
            <translation>outra tarefa está aberta no painel de tarefas</translation>
        </message>
        <message>
            <source>ask for the right to use it</source>
            <translation>peça permissão para usá-la</translation>
        </message>
        <message>
            <source>at least {0} mm</source>
            <translation>ao menos {0} mm</translation>
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
            <source>axis words stand where no command uses them</source>
            <translation>há palavras de eixo onde nenhum comando as usa</translation>
        </message>
        <message>
            <source>axis.{0} is missing</source>
            <translation>falta axis.{0}</translation>
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
            <source>below {0} mm</source>
            <translation>abaixo de {0} mm</translation>
        </message>
        <message>
            <source>both radii must be positive</source>
            <translation>os dois semieixos devem ser positivos</translation>
        </message>
        <message>
            <source>bring it to Idle first</source>
            <translation>deixe-a antes em Idle (pronta)</translation>
        </message>
        <message>
            <source>check both switches</source>
            <translation>verifique os dois fins de curso</translation>
        </message>
        <message>
            <source>check cable and baud rate</source>
            <translation>verifique o cabo e a taxa (baud)</translation>
        </message>
        <message>
            <source>check cable and power; home the machine or set its zero again before the next cut</source>
            <translation>verifique cabo e alimentação; referencie a máquina ou defina o zero de novo antes do próximo corte</translation>
        </message>
        <message>
            <source>check cable, power and other programs on this port</source>
            <translation>verifique cabo, alimentação e outros programas nesta porta</translation>
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
            <source>check the cable</source>
            <translation>verifique o cabo</translation>
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
            <source>check the switches, and travel $130 to $132</source>
            <translation>verifique os fins de curso e os cursos $130 a $132</translation>
        </message>
        <message>
            <source>chip_load_min_mm must not exceed chip_load_max_mm</source>
            <translation>chip_load_min_mm não pode exceder chip_load_max_mm</translation>
        </message>
        <message>
            <source>choose S from {0} to {1}</source>
            <translation>escolha S de {0} a {1}</translation>
        </message>
        <message>
            <source>choose a folder that exists and that you may write to</source>
            <translation>escolha uma pasta que exista e em que você possa gravar</translation>
        </message>
        <message>
            <source>choose a sketch, wire, B-spline or freehand line for it</source>
            <translation>escolha para ela um esboço, arame, B-spline ou linha à mão livre</translation>
        </message>
        <message>
            <source>choose a smaller tool</source>
            <translation>escolha uma ferramenta menor</translation>
        </message>
        <message>
            <source>choose a solid, for example a box</source>
            <translation>escolha um sólido, por exemplo uma caixa</translation>
        </message>
        <message>
            <source>choose another</source>
            <translation>escolha outro</translation>
        </message>
        <message>
            <source>choose one of the job's tools for it</source>
            <translation>escolha para ela uma das ferramentas do trabalho</translation>
        </message>
        <message>
            <source>choose one of: {0}</source>
            <translation>escolha um destes: {0}</translation>
        </message>
        <message>
            <source>choose the right machine profile, or correct the settings</source>
            <translation>escolha o perfil de máquina certo, ou corrija as configurações</translation>
        </message>
        <message>
            <source>clearance_mm must not be below retract_mm</source>
            <translation>clearance_mm (altura de segurança) não pode ser menor que retract_mm (retração)</translation>
        </message>
        <message>
            <source>close it and home again</source>
            <translation>feche-a e referencie de novo</translation>
        </message>
        <message>
            <source>close it first</source>
            <translation>feche-a antes</translation>
        </message>
        <message>
            <source>close it or set closed = false</source>
            <translation>feche-a ou use closed = false</translation>
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
            <source>core_diameter_mm must not exceed diameter_mm</source>
            <translation>core_diameter_mm não pode exceder diameter_mm</translation>
        </message>
        <message>
            <source>corner_radius_mm must not exceed half of diameter_mm</source>
            <translation>corner_radius_mm não pode passar da metade de diameter_mm</translation>
        </message>
        <message>
            <source>correct its spelling or take it out; known are: {0}</source>
            <translation>corrija a grafia ou retire-a; são conhecidas: {0}</translation>
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
            <source>correct that line of the program</source>
            <translation>corrija essa linha do programa</translation>
        </message>
        <message>
            <source>correct that value</source>
            <translation>corrija esse valor</translation>
        </message>
        <message>
            <source>correct the jog command</source>
            <translation>corrija o comando de jog</translation>
        </message>
        <message>
            <source>correct the path, the tool's diameter or the depth</source>
            <translation>corrija a trajetória, o diâmetro da ferramenta ou a profundidade</translation>
        </message>
        <message>
            <source>correct the program, and check it again</source>
            <translation>corrija o programa e verifique-o de novo</translation>
        </message>
        <message>
            <source>correct work zero or program, then unlock with $X; the position is kept</source>
            <translation>corrija o zero-peça ou o programa e destrave com $X; a posição se mantém</translation>
        </message>
        <message>
            <source>curves do not meet</source>
            <translation>as curvas não se encontram</translation>
        </message>
        <message>
            <source>cut in more levels, or take a longer tool</source>
            <translation>usine em mais níveis, ou use uma ferramenta mais longa</translation>
        </message>
        <message>
            <source>draw at least two points</source>
            <translation>desenhe ao menos dois pontos</translation>
        </message>
        <message>
            <source>draw it on the XY plane or on one parallel to it</source>
            <translation>desenhe-o no plano XY ou em um paralelo a ele</translation>
        </message>
        <message>
            <source>draw something in it, or choose another drawing</source>
            <translation>desenhe algo nele, ou escolha outro desenho</translation>
        </message>
        <message>
            <source>edge_mm must not be below zero</source>
            <translation>edge_mm não pode ser menor que zero</translation>
        </message>
        <message>
            <source>enable homing ($22=1) or switch soft limits off ($20=0)</source>
            <translation>habilite o referenciamento ($22=1) ou desligue os limites de software ($20=0)</translation>
        </message>
        <message>
            <source>end it in .gif, or install ffmpeg</source>
            <translation>use a extensão .gif, ou instale o ffmpeg</translation>
        </message>
        <message>
            <source>enter by a helix or ramp, or in the middle of a hole drilled before</source>
            <translation>entre em hélice ou rampa, ou no meio de um furo já aberto</translation>
        </message>
        <message>
            <source>exclusively lock</source>
            <translation>exclusively lock</translation>
        </message>
        <message>
            <source>find the cause, then home the machine: its position is lost</source>
            <translation>encontre a causa e referencie a máquina: a posição se perdeu</translation>
        </message>
        <message>
            <source>finish_stepover_mm (ae_acab) is larger than the tool's radius allows</source>
            <translation>finish_stepover_mm (ae_acab) é maior do que o raio da ferramenta permite</translation>
        </message>
        <message>
            <source>finish_{0} leaves nothing to rough</source>
            <translation>finish_{0} não deixa nada para desbastar</translation>
        </message>
        <message>
            <source>flute_length_mm must not exceed length_mm</source>
            <translation>flute_length_mm não pode passar de length_mm</translation>
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
            <source>give X,Y,Z in mm, for example 100,70,20</source>
            <translation>dê X,Y,Z em mm, por exemplo 100,70,20</translation>
        </message>
        <message>
            <source>give a TOML file or one of: {0}</source>
            <translation>dê um arquivo TOML ou um destes: {0}</translation>
        </message>
        <message>
            <source>give a device name or socket://host:port</source>
            <translation>dê um nome de dispositivo ou socket://host:porta</translation>
        </message>
        <message>
            <source>give a finite number</source>
            <translation>dê um número finito</translation>
        </message>
        <message>
            <source>give a way of 0.0001 mm or more and a feed above 0</source>
            <translation>dê uma distância de 0,0001 mm ou mais e um avanço acima de 0</translation>
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
            <source>give every row as many</source>
            <translation>dê a mesma quantidade a cada linha</translation>
        </message>
        <message>
            <source>give heights over the bottom, and the largest as the stock's Z</source>
            <translation>dê alturas acima do fundo, e a maior como Z do bloco</translation>
        </message>
        <message>
            <source>give its diameter for X and for Y</source>
            <translation>dê o diâmetro para X e para Y</translation>
        </message>
        <message>
            <source>give its {0}</source>
            <translation>informe {0} dela</translation>
        </message>
        <message>
            <source>give the path of a TOML job file</source>
            <translation>dê o caminho de um arquivo de trabalho TOML</translation>
        </message>
        <message>
            <source>give the stock and the tools</source>
            <translation>informe o bloco e as ferramentas</translation>
        </message>
        <message>
            <source>give the timeline its machine</source>
            <translation>informe a máquina à linha do tempo</translation>
        </message>
        <message>
            <source>give the tool a {0}</source>
            <translation>dê à ferramenta um {0}</translation>
        </message>
        <message>
            <source>give the work zero to have the travel checked</source>
            <translation>informe o zero-peça para que o curso seja verificado</translation>
        </message>
        <message>
            <source>give two opposite corners of a rectangle, or three and more of a polygon in their order</source>
            <translation>informe dois cantos opostos de um retângulo, ou três ou mais de um polígono, na ordem</translation>
        </message>
        <message>
            <source>heights belong to a stock of the form 'height_field', and to no other</source>
            <translation>alturas pertencem a um bloco da forma 'height_field', e a nenhum outro</translation>
        </message>
        <message>
            <source>heights differ by {0} mm</source>
            <translation>as alturas diferem em {0} mm</translation>
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
            <source>home the machine, or unlock it with $X</source>
            <translation>referencie a máquina, ou destrave-a com $X</translation>
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
            <source>homing was interrupted by a reset</source>
            <translation>o referenciamento foi interrompido por um reset</translation>
        </message>
        <message>
            <source>install it for the Python that proves (python -m pip install NAME)</source>
            <translation>instale-o para o Python que verifica (python -m pip install NOME)</translation>
        </message>
        <message>
            <source>install it: python -m pip install platformdirs</source>
            <translation>instale-o: python -m pip install platformdirs</translation>
        </message>
        <message>
            <source>install it: python -m pip install pyserial</source>
            <translation>instale-o: python -m pip install pyserial</translation>
        </message>
        <message>
            <source>install them in one (python -m pip install {0}), or set {1} to a Python that has them</source>
            <translation>instale-os em um (python -m pip install {0}), ou aponte {1} para um Python que os tenha</translation>
        </message>
        <message>
            <source>it ended with an error</source>
            <translation>terminou com um erro</translation>
        </message>
        <message>
            <source>it has: {0}</source>
            <translation>ele tem: {0}</translation>
        </message>
        <message>
            <source>jog less far</source>
            <translation>mova menos</translation>
        </message>
        <message>
            <source>laser mode needs a variable spindle output</source>
            <translation>o modo laser exige saída de spindle variável</translation>
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
            <source>leave the N words out</source>
            <translation>omita as palavras N</translation>
        </message>
        <message>
            <source>leave the check mode with $C</source>
            <translation>saia do modo de verificação com $C</translation>
        </message>
        <message>
            <source>let the tool stick out farther</source>
            <translation>deixe a ferramenta mais para fora do porta-ferramenta</translation>
        </message>
        <message>
            <source>lift the tool before it</source>
            <translation>levante a ferramenta antes dele</translation>
        </message>
        <message>
            <source>lift the tool over it, move the clamp or move the shape</source>
            <translation>levante a ferramenta acima dele, mude o grampo de lugar ou desloque a forma</translation>
        </message>
        <message>
            <source>look at its switches</source>
            <translation>examine os fins de curso</translation>
        </message>
        <message>
            <source>look the code up in the controller's documentation</source>
            <translation>procure o código na documentação do controlador</translation>
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
            <source>lower steps/mm or maximum rate</source>
            <translation>diminua os passos/mm ou a velocidade máxima</translation>
        </message>
        <message>
            <source>lower the feed here, or the axis' rate and acceleration in controller and profile</source>
            <translation>diminua o avanço aqui, ou a velocidade e a aceleração do eixo no controlador e no perfil</translation>
        </message>
        <message>
            <source>lower the stepover, enter by a helix, or leave less in the corners</source>
            <translation>diminua a penetração de trabalho, entre em hélice, ou deixe menos material nos cantos</translation>
        </message>
        <message>
            <source>make finish_{0} smaller</source>
            <translation>diminua finish_{0}</translation>
        </message>
        <message>
            <source>make it again</source>
            <translation>refaça-o</translation>
        </message>
        <message>
            <source>make it smaller, or islands remain</source>
            <translation>diminua-a, ou sobram ilhas</translation>
        </message>
        <message>
            <source>make resolution_mm larger</source>
            <translation>aumente resolution_mm</translation>
        </message>
        <message>
            <source>make the passes, the levels, the resolution or the entry angle larger</source>
            <translation>aumente os passes, os níveis, a resolução ou o ângulo de entrada</translation>
        </message>
        <message>
            <source>make the program smaller, split it, or use a larger machine</source>
            <translation>diminua o programa, divida-o ou use uma máquina maior</translation>
        </message>
        <message>
            <source>make {0} larger</source>
            <translation>aumente {0}</translation>
        </message>
        <message>
            <source>material is left where it should be removed{0}</source>
            <translation>sobra material onde deveria ser removido{0}</translation>
        </message>
        <message>
            <source>mend that object first</source>
            <translation>corrija antes esse objeto</translation>
        </message>
        <message>
            <source>more of the {0} tool's rim is in the material than it may</source>
            <translation>o ângulo de contato da ferramenta {0} com o material é maior que o permitido</translation>
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
            <source>move the work zero {0} the {1} axis or make the program smaller</source>
            <translation>mova o zero-peça ({0}) no eixo {1} ou diminua o programa</translation>
        </message>
        <message>
            <source>name X and Y in a rapid above the stock first</source>
            <translation>indique antes X e Y em um rápido acima do bloco</translation>
        </message>
        <message>
            <source>no encoder for '{0}' is installed</source>
            <translation>não há codificador instalado para '{0}'</translation>
        </message>
        <message>
            <source>no feed rate was set</source>
            <translation>nenhum avanço foi definido</translation>
        </message>
        <message>
            <source>no parallel curve that far inside</source>
            <translation>não há curva paralela tão para dentro</translation>
        </message>
        <message>
            <source>nobody has confirmed the work zero</source>
            <translation>ninguém confirmou o zero-peça</translation>
        </message>
        <message>
            <source>not a JSON file: {0}</source>
            <translation>não é um arquivo JSON: {0}</translation>
        </message>
        <message>
            <source>not a TOML file: {0}</source>
            <translation>não é um arquivo TOML: {0}</translation>
        </message>
        <message>
            <source>not a curve with xy and bulge: {0}</source>
            <translation>não é uma curva com xy e bulge: {0}</translation>
        </message>
        <message>
            <source>not a job to send: {0}</source>
            <translation>não é um trabalho para enviar: {0}</translation>
        </message>
        <message>
            <source>not a job: the file holds no object</source>
            <translation>não é um trabalho: o arquivo não contém um objeto</translation>
        </message>
        <message>
            <source>not finite: {0}</source>
            <translation>não é finito: {0}</translation>
        </message>
        <message>
            <source>not the numbers of a curve: {0}</source>
            <translation>não são os números de uma curva: {0}</translation>
        </message>
        <message>
            <source>nothing answers</source>
            <translation>nada responde</translation>
        </message>
        <message>
            <source>nothing answers at {0}: {1}</source>
            <translation>nada responde em {0}: {1}</translation>
        </message>
        <message>
            <source>nothing is known that could be asked so</source>
            <translation>não se conhece nada que se possa perguntar assim</translation>
        </message>
        <message>
            <source>nothing moves</source>
            <translation>nada se move</translation>
        </message>
        <message>
            <source>nothing moves that could be held</source>
            <translation>nada se move que possa ser pausado</translation>
        </message>
        <message>
            <source>only a closed curve can start elsewhere</source>
            <translation>só uma curva fechada pode começar em outro lugar</translation>
        </message>
        <message>
            <source>only {0} of {1} bytes were taken</source>
            <translation>só {0} de {1} bytes foram aceitos</translation>
        </message>
        <message>
            <source>operation '{0}' uses tool {1}, which the job does not have</source>
            <translation>a operação '{0}' usa a ferramenta {1}, que o trabalho não tem</translation>
        </message>
        <message>
            <source>part of the drawn shape lies beside the stock</source>
            <translation>parte da forma desenhada fica fora do bloco</translation>
        </message>
        <message>
            <source>platformdirs is not installed</source>
            <translation>o platformdirs não está instalado</translation>
        </message>
        <message>
            <source>please report it, with the program</source>
            <translation>relate-o, por favor, com o programa</translation>
        </message>
        <message>
            <source>plug the controller in, or give one of the ports that are there: {0}</source>
            <translation>conecte o controlador, ou indique uma das portas que há: {0}</translation>
        </message>
        <message>
            <source>points are not pairs of x and y</source>
            <translation>os pontos não são pares de x e y</translation>
        </message>
        <message>
            <source>prepare the program again</source>
            <translation>prepare o programa de novo</translation>
        </message>
        <message>
            <source>prove parts of the program alone</source>
            <translation>verifique partes do programa em separado</translation>
        </message>
        <message>
            <source>pulses are those of a machine</source>
            <translation>os pulsos são os de uma máquina</translation>
        </message>
        <message>
            <source>pyserial is not installed</source>
            <translation>o pyserial não está instalado</translation>
        </message>
        <message>
            <source>radii and resolution must be positive</source>
            <translation>os semieixos e a resolução devem ser positivos</translation>
        </message>
        <message>
            <source>raise F, or turn the spindle slower</source>
            <translation>aumente F, ou diminua a rotação do spindle</translation>
        </message>
        <message>
            <source>raise the pull-off $27 or check the switch</source>
            <translation>aumente o recuo $27 ou verifique o fim de curso</translation>
        </message>
        <message>
            <source>remove it; only plain ASCII without ? ! ~ may be sent</source>
            <translation>remova-o; só ASCII puro sem ? ! ~ pode ser enviado</translation>
        </message>
        <message>
            <source>resolution_mm is too coarse for the tool</source>
            <translation>resolution_mm é grossa demais para a ferramenta</translation>
        </message>
        <message>
            <source>resume what it was doing, or reset it</source>
            <translation>retome o que fazia, ou reinicie-a</translation>
        </message>
        <message>
            <source>run 'make setup' beside the workbench, or let Tools &gt; Addon Manager install them, or install them for Python {0}.{1} into a folder of their own (pip install --target FOLDER) and name it in the environment variable CNCSTEPPER_PACKAGES</source>
            <translation>rode 'make setup' na pasta da bancada, ou instale-os por Ferramentas &gt; Gerenciador de extensões, ou instale-os para Python {0}.{1} em uma pasta própria (pip install --target PASTA) e indique-a na variável de ambiente CNCSTEPPER_PACKAGES</translation>
        </message>
        <message>
            <source>see its log, report it</source>
            <translation>veja o registro e relate-o</translation>
        </message>
        <message>
            <source>see whether it is whole</source>
            <translation>veja se está completo</translation>
        </message>
        <message>
            <source>send another one</source>
            <translation>envie outro</translation>
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
            <source>set it again, and do not start before it is right</source>
            <translation>defina-o de novo, e não inicie antes que esteja certo</translation>
        </message>
        <message>
            <source>set the machine's settings again</source>
            <translation>refaça as configurações da máquina</translation>
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
            <source>soft limits need homing</source>
            <translation>limites de software exigem referenciamento</translation>
        </message>
        <message>
            <source>something else than grbl answers</source>
            <translation>quem responde não é um grbl</translation>
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
            <source>start it with cncstepper send</source>
            <translation>inicie-o com cncstepper send</translation>
        </message>
        <message>
            <source>start it, or correct the URL</source>
            <translation>inicie-o, ou corrija a URL</translation>
        </message>
        <message>
            <source>start nearer to the part, then unlock with $X</source>
            <translation>comece mais perto da peça e destrave com $X</translation>
        </message>
        <message>
            <source>start the spindle with M3 and S before it</source>
            <translation>ligue o spindle com M3 e S antes dele</translation>
        </message>
        <message>
            <source>stepover_mm (ae) is larger than the tool</source>
            <translation>stepover_mm (ae) é maior que a ferramenta</translation>
        </message>
        <message>
            <source>stop with M5 and M0 before the new tool</source>
            <translation>pare com M5 e M0 antes da nova ferramenta</translation>
        </message>
        <message>
            <source>stopped as asked after {0} lines</source>
            <translation>parado como pedido após {0} linhas</translation>
        </message>
        <message>
            <source>stopped before the first line was sent</source>
            <translation>parado antes de enviar a primeira linha</translation>
        </message>
        <message>
            <source>switch it off with M5 before it</source>
            <translation>desligue-o antes com M5</translation>
        </message>
        <message>
            <source>switch it on with M3 and S before it</source>
            <translation>ligue-o antes com M3 e S</translation>
        </message>
        <message>
            <source>take out {0}</source>
            <translation>retire {0}</translation>
        </message>
        <message>
            <source>the $ command is not known</source>
            <translation>o comando $ não é conhecido</translation>
        </message>
        <message>
            <source>the arc has no axis word of its plane</source>
            <translation>o arco não tem palavra de eixo do seu plano</translation>
        </message>
        <message>
            <source>the arc lacks its centre offset in the plane</source>
            <translation>falta ao arco o deslocamento do centro no plano</translation>
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
            <source>the beam is never on where it is to cut</source>
            <translation>o feixe nunca está ligado onde deveria cortar</translation>
        </message>
        <message>
            <source>the certificate cannot be read</source>
            <translation>o certificado não pode ser lido</translation>
        </message>
        <message>
            <source>the certificate is of another version</source>
            <translation>o certificado é de outra versão</translation>
        </message>
        <message>
            <source>the certificate lacks what a sender needs</source>
            <translation>falta no certificado o que o envio precisa</translation>
        </message>
        <message>
            <source>the certificate was changed after it was made</source>
            <translation>o certificado foi alterado depois de emitido</translation>
        </message>
        <message>
            <source>the character {0} would act as a command of its own or is not ASCII</source>
            <translation>o caractere {0} agiria como um comando ou não é ASCII</translation>
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
            <source>the controller does not answer any more</source>
            <translation>o controlador não responde mais</translation>
        </message>
        <message>
            <source>the controller does not come back from its reset</source>
            <translation>o controlador não volta do reset</translation>
        </message>
        <message>
            <source>the controller does not know this command</source>
            <translation>o controlador não conhece este comando</translation>
        </message>
        <message>
            <source>the controller does not report ${0}: it was not compared</source>
            <translation>o controlador não informa ${0}: não foi comparado</translation>
        </message>
        <message>
            <source>the controller does not report its {0}</source>
            <translation>o controlador não informa: {0}</translation>
        </message>
        <message>
            <source>the controller does not say its work system: {0}</source>
            <translation>o controlador não informa o sistema de coordenadas: {0}</translation>
        </message>
        <message>
            <source>the controller does not tell its state</source>
            <translation>o controlador não informa o seu estado</translation>
        </message>
        <message>
            <source>the controller is idle but has not answered '{0}'</source>
            <translation>o controlador está pronto mas não respondeu '{0}'</translation>
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
            <source>the controller raised an alarm</source>
            <translation>o controlador entrou em alarme</translation>
        </message>
        <message>
            <source>the controller refused '{0}': {1} (error:{2})</source>
            <translation>o controlador recusou '{0}': {1} (error:{2})</translation>
        </message>
        <message>
            <source>the controller refused the line</source>
            <translation>o controlador recusou a linha</translation>
        </message>
        <message>
            <source>the controller refused {0}: {1} (error:{2})</source>
            <translation>o controlador recusou {0}: {1} (error:{2})</translation>
        </message>
        <message>
            <source>the controller restarted in the middle of the job</source>
            <translation>o controlador reiniciou no meio do trabalho</translation>
        </message>
        <message>
            <source>the controller restarted when its port was opened; it counts from where it stands</source>
            <translation>o controlador reiniciou quando a porta foi aberta; ele conta a partir de onde está</translation>
        </message>
        <message>
            <source>the controller said: {0}</source>
            <translation>o controlador disse: {0}</translation>
        </message>
        <message>
            <source>the controller sleeps and its motors are off: unlock it, then home it or set its zero again</source>
            <translation>o controlador dorme e os motores estão desligados: destrave-o, depois referencie ou defina o zero de novo</translation>
        </message>
        <message>
            <source>the controller was reset while moving</source>
            <translation>o controlador foi reiniciado em movimento</translation>
        </message>
        <message>
            <source>the corners of a clamp enclose nothing</source>
            <translation>os cantos de um grampo não delimitam nenhuma área</translation>
        </message>
        <message>
            <source>the curve is not smooth here</source>
            <translation>a curva não é suave aqui</translation>
        </message>
        <message>
            <source>the cut begins without waiting for the spindle</source>
            <translation>o corte começa sem esperar o spindle</translation>
        </message>
        <message>
            <source>the cut comes too near to the sheet's edge</source>
            <translation>o corte chega perto demais da borda da chapa</translation>
        </message>
        <message>
            <source>the desk cannot be started: {0}</source>
            <translation>a mesa de controle não pode ser iniciada: {0}</translation>
        </message>
        <message>
            <source>the desk failed by a fault of its own</source>
            <translation>a mesa de controle falhou por um defeito próprio</translation>
        </message>
        <message>
            <source>the desk of {0} is not there, or was killed</source>
            <translation>a mesa de controle de {0} não existe ou foi encerrada</translation>
        </message>
        <message>
            <source>the desk's process does not come up</source>
            <translation>o processo da mesa de controle não inicia</translation>
        </message>
        <message>
            <source>the drawing '{0}' does not lie flat</source>
            <translation>o desenho '{0}' não é plano</translation>
        </message>
        <message>
            <source>the drawing '{0}' holds a line that is no ellipse</source>
            <translation>o desenho '{0}' tem uma linha que não é elipse</translation>
        </message>
        <message>
            <source>the drawing '{0}' holds more than one ellipse</source>
            <translation>o desenho '{0}' tem mais de uma elipse</translation>
        </message>
        <message>
            <source>the drawing '{0}' holds no lines</source>
            <translation>o desenho '{0}' não tem linhas</translation>
        </message>
        <message>
            <source>the drawing '{0}' that it followed was deleted</source>
            <translation>o desenho '{0}' que ela seguia foi excluído</translation>
        </message>
        <message>
            <source>the ellipse in '{0}' is open</source>
            <translation>a elipse em '{0}' está aberta</translation>
        </message>
        <message>
            <source>the ellipse's ends are tighter than the tool, where similar ellipses would cut into the wall</source>
            <translation>as pontas da elipse são mais fechadas que a ferramenta, e elipses semelhantes cortariam a parede ali</translation>
        </message>
        <message>
            <source>the feed asks more of {0} than its highest rate</source>
            <translation>o avanço pede de {0} mais que a sua velocidade máxima</translation>
        </message>
        <message>
            <source>the heights do not fit their box</source>
            <translation>as alturas não cabem na sua caixa</translation>
        </message>
        <message>
            <source>the holder</source>
            <translation>o porta-ferramenta</translation>
        </message>
        <message>
            <source>the holder of the {0} tool goes into stock</source>
            <translation>o porta-ferramenta da ferramenta {0} entra no material</translation>
        </message>
        <message>
            <source>the job cannot be read: {0}</source>
            <translation>o trabalho não pode ser lido: {0}</translation>
        </message>
        <message>
            <source>the job has no operations</source>
            <translation>o trabalho não tem operações</translation>
        </message>
        <message>
            <source>the job was deleted</source>
            <translation>o trabalho foi apagado</translation>
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
            <source>the jog was stopped: its button was not heard of for {0} s</source>
            <translation>o movimento manual foi parado: sem notícia do botão por {0} s</translation>
        </message>
        <message>
            <source>the jogs before this one are not done yet</source>
            <translation>os movimentos manuais anteriores ainda não terminaram</translation>
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
            <source>the line has no length</source>
            <translation>a linha não tem comprimento</translation>
        </message>
        <message>
            <source>the line is longer than grbl can read</source>
            <translation>a linha é mais longa do que o grbl consegue ler</translation>
        </message>
        <message>
            <source>the line is too long</source>
            <translation>a linha é longa demais</translation>
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
            <source>the lines to send are not those that were proven</source>
            <translation>as linhas a enviar não são as que foram verificadas</translation>
        </message>
        <message>
            <source>the link to {0} broke: {1}</source>
            <translation>a ligação com {0} caiu: {1}</translation>
        </message>
        <message>
            <source>the machine does not end its homing</source>
            <translation>a máquina não termina o referenciamento</translation>
        </message>
        <message>
            <source>the machine does not home: {0} (error:{1})</source>
            <translation>a máquina não referencia: {0} (error:{1})</translation>
        </message>
        <message>
            <source>the machine has no {0} coolant</source>
            <translation>a máquina não tem refrigeração {0}</translation>
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
            <source>the machine jogs only while it is idle</source>
            <translation>o movimento manual só funciona com a máquina pronta</translation>
        </message>
        <message>
            <source>the machine stands, spindle and outputs are off, its position is kept (the reset cleared G92 and tool length)</source>
            <translation>a máquina está parada, spindle e saídas desligados, a posição se mantém (o reset apagou G92 e o comprimento da ferramenta)</translation>
        </message>
        <message>
            <source>the machine's position is unknown: look that spindle and outputs are off, then home it or set its zero again</source>
            <translation>a posição da máquina é desconhecida: veja se o spindle e as saídas estão desligados, depois referencie ou defina o zero de novo</translation>
        </message>
        <message>
            <source>the motor of {0} may lose steps: at {1} mm/s ({2} rpm) and {3} mm/s² it has too little torque</source>
            <translation>o motor de {0} pode perder passos: a {1} mm/s ({2} rpm) e {3} mm/s² falta-lhe torque</translation>
        </message>
        <message>
            <source>the move leaves the travel of {0} by {1} mm</source>
            <translation>o movimento sai do curso de {0} por {1} mm</translation>
        </message>
        <message>
            <source>the operation is too long for one program</source>
            <translation>a operação é longa demais para um programa</translation>
        </message>
        <message>
            <source>the pocket is too narrow for a {0}</source>
            <translation>o bolsão é estreito demais para uma {0}</translation>
        </message>
        <message>
            <source>the points of a freehand line lie at different heights</source>
            <translation>os pontos de uma linha à mão livre estão em alturas diferentes</translation>
        </message>
        <message>
            <source>the probe touched nothing</source>
            <translation>o apalpador não tocou em nada</translation>
        </message>
        <message>
            <source>the probe was not in its start state</source>
            <translation>o apalpador não estava no estado inicial</translation>
        </message>
        <message>
            <source>the process that knows the part at every moment has ended</source>
            <translation>o processo que conhece a peça em cada momento terminou</translation>
        </message>
        <message>
            <source>the process that proves cannot be started</source>
            <translation>o processo de verificação não pode ser iniciado</translation>
        </message>
        <message>
            <source>the process that proves the program ended without an answer</source>
            <translation>o processo que verifica o programa terminou sem resposta</translation>
        </message>
        <message>
            <source>the program cannot be written: {0}</source>
            <translation>o programa não pode ser gravado: {0}</translation>
        </message>
        <message>
            <source>the program has no line to send</source>
            <translation>o programa não tem linha a enviar</translation>
        </message>
        <message>
            <source>the program is larger than the travel of {0}</source>
            <translation>o programa é maior que o curso de {0}</translation>
        </message>
        <message>
            <source>the program is not the one that was proven: its text differs</source>
            <translation>o programa não é o que foi verificado: o texto é outro</translation>
        </message>
        <message>
            <source>the program moves nothing</source>
            <translation>o programa não move nada</translation>
        </message>
        <message>
            <source>the program pauses while the spindle turns</source>
            <translation>o programa espera com o spindle girando</translation>
        </message>
        <message>
            <source>the program was proven for another machine, or its profile was changed since</source>
            <translation>o programa foi verificado para outra máquina, ou o perfil dela mudou desde então</translation>
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
            <source>the proof failed by a fault of its own: {0}: {1}</source>
            <translation>a verificação falhou por um defeito próprio: {0}: {1}</translation>
        </message>
        <message>
            <source>the proof found {0} error(s) in the program, the first: {1}</source>
            <translation>a verificação encontrou {0} erro(s) no programa, o primeiro: {1}</translation>
        </message>
        <message>
            <source>the resolution is too fine for the ellipse</source>
            <translation>a resolução é fina demais para a elipse</translation>
        </message>
        <message>
            <source>the rows of heights differ in length</source>
            <translation>as linhas de alturas têm comprimentos diferentes</translation>
        </message>
        <message>
            <source>the safety door is open or the machine is parking ({0}): resume later</source>
            <translation>a porta de segurança está aberta ou a máquina está estacionando ({0}): retome depois</translation>
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
            <source>the second limit switch of a double axis was not found</source>
            <translation>o segundo fim de curso de um eixo duplo não foi encontrado</translation>
        </message>
        <message>
            <source>the sender failed by a fault of its own</source>
            <translation>o envio falhou por um defeito próprio</translation>
        </message>
        <message>
            <source>the sender's process does not answer</source>
            <translation>o processo de envio não responde</translation>
        </message>
        <message>
            <source>the sender's process does not come up</source>
            <translation>o processo de envio não inicia</translation>
        </message>
        <message>
            <source>the sender's process ended at once</source>
            <translation>o processo de envio terminou logo</translation>
        </message>
        <message>
            <source>the session refused {0}</source>
            <translation>a sessão recusou {0}</translation>
        </message>
        <message>
            <source>the session still runs</source>
            <translation>a sessão ainda está em curso</translation>
        </message>
        <message>
            <source>the session {0} is not there, or was killed</source>
            <translation>a sessão {0} não existe ou foi encerrada</translation>
        </message>
        <message>
            <source>the session's log</source>
            <translation>o registro da sessão</translation>
        </message>
        <message>
            <source>the shank of the {0} tool rubs along the wall over its flutes</source>
            <translation>a haste da ferramenta {0} atrita na parede acima da parte cortante</translation>
        </message>
        <message>
            <source>the spindle cannot turn at this speed</source>
            <translation>o spindle não pode girar nesta rotação</translation>
        </message>
        <message>
            <source>the step pulse is shorter than 3 microseconds</source>
            <translation>o pulso de passo é menor que 3 microssegundos</translation>
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
            <source>the timeline failed by a fault of its own: {0}: {1}</source>
            <translation>a linha do tempo falhou por um defeito próprio: {0}: {1}</translation>
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
            <source>the tool cuts into the wanted part</source>
            <translation>a ferramenta corta a peça desejada</translation>
        </message>
        <message>
            <source>the tool goes below the stock and cuts what lies under it</source>
            <translation>a ferramenta passa abaixo do bloco e corta o que está embaixo</translation>
        </message>
        <message>
            <source>the tool is below the stock's top while its place in X or Y is not known</source>
            <translation>a ferramenta está abaixo do topo do bloco sem que o seu lugar em X ou Y seja conhecido</translation>
        </message>
        <message>
            <source>the tool is wider than the pocket</source>
            <translation>a ferramenta é mais larga que o bolsão</translation>
        </message>
        <message>
            <source>the tool number is too large</source>
            <translation>o número da ferramenta é grande demais</translation>
        </message>
        <message>
            <source>the value must be a whole number</source>
            <translation>o valor deve ser um número inteiro</translation>
        </message>
        <message>
            <source>the virtual grbl ended at once</source>
            <translation>o grbl virtual terminou logo</translation>
        </message>
        <message>
            <source>the wall may be up to {0} mm off: an ellipse is no offset of an ellipse, and the resolution adds to it; method "tolerance" keeps to tolerance_mm</source>
            <translation>a parede pode desviar até {0} mm: uma elipse não é paralela a outra elipse, e a resolução se soma a isso; o método "tolerance" respeita tolerance_mm</translation>
        </message>
        <message>
            <source>the work systems G59.1 to G59.3 do not exist here</source>
            <translation>os sistemas de coordenadas G59.1 a G59.3 não existem aqui</translation>
        </message>
        <message>
            <source>the work zero is not known, so the program's place on the table is unknown</source>
            <translation>o zero-peça não é conhecido, por isso o lugar do programa na mesa é desconhecido</translation>
        </message>
        <message>
            <source>the zero of {0} in {1} was not taken over</source>
            <translation>o zero de {0} em {1} não foi aceito</translation>
        </message>
        <message>
            <source>the {0} tool cuts deeper than its flutes are long</source>
            <translation>a ferramenta {0} corta mais fundo que o seu comprimento de corte</translation>
        </message>
        <message>
            <source>the {0} tool is too small against its path for its engagement to be measured</source>
            <translation>a ferramenta {0} é pequena demais diante da trajetória para se medir o seu ângulo de contato</translation>
        </message>
        <message>
            <source>the {0} tool rubs: a tooth takes too thin a chip</source>
            <translation>a ferramenta {0} atrita em vez de cortar: um dente tira um cavaco fino demais</translation>
        </message>
        <message>
            <source>the {0} tool's form is not given, so it is judged as a flat one of its diameter</source>
            <translation>a forma da ferramenta {0} não foi informada, por isso é avaliada como fresa reta do mesmo diâmetro</translation>
        </message>
        <message>
            <source>there is no command '{0}'</source>
            <translation>não há comando '{0}'</translation>
        </message>
        <message>
            <source>there is no cycle '{0}'</source>
            <translation>não há ciclo '{0}'</translation>
        </message>
        <message>
            <source>there is no job file '{0}'</source>
            <translation>não há arquivo de trabalho '{0}'</translation>
        </message>
        <message>
            <source>there is no key {0}</source>
            <translation>não há chave {0}</translation>
        </message>
        <message>
            <source>there is no machine profile '{0}'</source>
            <translation>não há perfil de máquina '{0}'</translation>
        </message>
        <message>
            <source>there is no override {0} {1}</source>
            <translation>não há ajuste {0} {1}</translation>
        </message>
        <message>
            <source>there is no part to draw</source>
            <translation>não há peça a desenhar</translation>
        </message>
        <message>
            <source>there is no port {0}</source>
            <translation>não há porta {0}</translation>
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
            <source>this client is detached</source>
            <translation>este cliente está desligado</translation>
        </message>
        <message>
            <source>this is no certificate</source>
            <translation>isto não é um certificado</translation>
        </message>
        <message>
            <source>tip_diameter_mm must be below diameter_mm</source>
            <translation>tip_diameter_mm deve ser menor que diameter_mm</translation>
        </message>
        <message>
            <source>tool {0} cuts on without a stop to change tool {1}</source>
            <translation>a ferramenta {0} continua o corte sem parada para trocar a ferramenta {1}</translation>
        </message>
        <message>
            <source>tool {0} has no {1}</source>
            <translation>a ferramenta {0} não tem {1}</translation>
        </message>
        <message>
            <source>tool {0} is not known, so what it cuts is not checked</source>
            <translation>a ferramenta {0} não é conhecida, por isso o que ela corta não é verificado</translation>
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
            <source>two commands of one line both want axis words</source>
            <translation>dois comandos de uma linha querem palavras de eixo</translation>
        </message>
        <message>
            <source>two tools have the same number</source>
            <translation>duas ferramentas têm o mesmo número</translation>
        </message>
        <message>
            <source>two words of one modal group stand in one line</source>
            <translation>duas palavras do mesmo grupo modal estão em uma linha</translation>
        </message>
        <message>
            <source>undo that, choose another drawing, or choose none</source>
            <translation>desfaça isso, escolha outro desenho, ou nenhum</translation>
        </message>
        <message>
            <source>unknown keys {0}</source>
            <translation>chaves desconhecidas {0}</translation>
        </message>
        <message>
            <source>update its firmware</source>
            <translation>atualize o firmware</translation>
        </message>
        <message>
            <source>use G54 to G59</source>
            <translation>use G54 a G59</translation>
        </message>
        <message>
            <source>use I and J instead of R</source>
            <translation>use I e J em vez de R</translation>
        </message>
        <message>
            <source>use a flat tool</source>
            <translation>use uma fresa de topo reto</translation>
        </message>
        <message>
            <source>use a mill, or lift the drill before it</source>
            <translation>use uma fresa, ou levante a broca antes disso</translation>
        </message>
        <message>
            <source>use a tool number up to 255</source>
            <translation>use um número de ferramenta até 255</translation>
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
            <source>use method "tolerance" or a smaller tool</source>
            <translation>use o método "tolerance" ou uma ferramenta menor</translation>
        </message>
        <message>
            <source>use one of: {0}</source>
            <translation>use um destes: {0}</translation>
        </message>
        <message>
            <source>use one that `$` lists</source>
            <translation>use um dos que `$` lista</translation>
        </message>
        <message>
            <source>wait a moment</source>
            <translation>espere um momento</translation>
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
            <source>wake it up with a reset, then home it</source>
            <translation>acorde-a com um reset e referencie-a</translation>
        </message>
        <message>
            <source>words were left over that no command uses</source>
            <translation>sobraram palavras que nenhum comando usa</translation>
        </message>
        <message>
            <source>work_offset must be one of {0}</source>
            <translation>work_offset deve ser um destes: {0}</translation>
        </message>
        <message>
            <source>write 0 where the edge does not matter</source>
            <translation>escreva 0 onde a borda não importa</translation>
        </message>
        <message>
            <source>write G4 P{0} after the spindle starts</source>
            <translation>escreva G4 P{0} depois de ligar o spindle</translation>
        </message>
        <message>
            <source>write M5 before M0</source>
            <translation>escreva M5 antes de M0</translation>
        </message>
        <message>
            <source>write for example XYZ, or Z alone</source>
            <translation>escreva por exemplo XYZ, ou só Z</translation>
        </message>
        <message>
            <source>write one of: {0}</source>
            <translation>escreva um destes: {0}</translation>
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
            <source>write the arc with more decimals</source>
            <translation>escreva o arco com mais decimais</translation>
        </message>
        <message>
            <source>write the program for the dialect grbl</source>
            <translation>gere o programa para o dialeto grbl</translation>
        </message>
        <message>
            <source>zero of {0} set in {1}</source>
            <translation>zero de {0} definido em {1}</translation>
        </message>
        <message>
            <source>{0} answered '{1}' to no line</source>
            <translation>{0} respondeu '{1}' a nenhuma linha</translation>
        </message>
        <message>
            <source>{0} asks for more than {1} passes</source>
            <translation>{0} pede mais de {1} passes</translation>
        </message>
        <message>
            <source>{0} cannot be '{1}'</source>
            <translation>{0} não pode ser '{1}'</translation>
        </message>
        <message>
            <source>{0} cannot be started: {1}</source>
            <translation>{0} não pode ser iniciado: {1}</translation>
        </message>
        <message>
            <source>{0} cannot be used as a serial port: {1}</source>
            <translation>{0} não pode ser usado como porta serial: {1}</translation>
        </message>
        <message>
            <source>{0} cannot be {1}: {2}</source>
            <translation>{0} não pode ser {1}: {2}</translation>
        </message>
        <message>
            <source>{0} characters, {1} with spaces</source>
            <translation>{0} caracteres, {1} com espaços</translation>
        </message>
        <message>
            <source>{0} does not answer {1}</source>
            <translation>{0} não responde a {1}</translation>
        </message>
        <message>
            <source>{0} goes into clamp {1}</source>
            <translation>{0} bate no grampo {1}</translation>
        </message>
        <message>
            <source>{0} has changed since the program was made</source>
            <translation>{0} mudou desde que o programa foi feito</translation>
        </message>
        <message>
            <source>{0} has no '{1}'</source>
            <translation>{0} não tem '{1}'</translation>
        </message>
        <message>
            <source>{0} has no drawing</source>
            <translation>{0} não tem desenho</translation>
        </message>
        <message>
            <source>{0} has no program: {1}</source>
            <translation>{0} não tem programa: {1}</translation>
        </message>
        <message>
            <source>{0} has no tool</source>
            <translation>{0} não tem ferramenta</translation>
        </message>
        <message>
            <source>{0} is in use</source>
            <translation>{0} está em uso</translation>
        </message>
        <message>
            <source>{0} is in use by another window's connection</source>
            <translation>{0} está em uso pela conexão de outra janela</translation>
        </message>
        <message>
            <source>{0} is no port: {1}</source>
            <translation>{0} não é uma porta: {1}</translation>
        </message>
        <message>
            <source>{0} is not the work system in force</source>
            <translation>{0} não é o sistema de coordenadas em vigor</translation>
        </message>
        <message>
            <source>{0} is {1}, wanted {2} mm</source>
            <translation>{0} é {1}, esperado {2} mm</translation>
        </message>
        <message>
            <source>{0} may not be opened by this user</source>
            <translation>{0} não pode ser aberta por este usuário</translation>
        </message>
        <message>
            <source>{0} mm high</source>
            <translation>{0} mm de altura</translation>
        </message>
        <message>
            <source>{0} mm of material stays at each end of the long axis, where the ellipse is tighter than the tool; a tool of at most {1} mm diameter reaches it</source>
            <translation>{0} mm de material ficam em cada ponta do eixo maior, onde a elipse é mais fechada que a ferramenta; uma ferramenta de no máximo {1} mm de diâmetro alcança</translation>
        </message>
        <message>
            <source>{0} mm radius</source>
            <translation>raio de {0} mm</translation>
        </message>
        <message>
            <source>{0} mm, {1} mm/min</source>
            <translation>{0} mm, {1} mm/min</translation>
        </message>
        <message>
            <source>{0} mm/min</source>
            <translation>{0} mm/min</translation>
        </message>
        <message>
            <source>{0} must be a list of tables</source>
            <translation>{0} deve ser uma lista de tabelas</translation>
        </message>
        <message>
            <source>{0} must be a number</source>
            <translation>{0} deve ser um número</translation>
        </message>
        <message>
            <source>{0} needs X, Y or X, Y, Z</source>
            <translation>{0} precisa de X, Y ou X, Y, Z</translation>
        </message>
        <message>
            <source>{0} points, {1} bulges</source>
            <translation>{0} pontos, {1} bulges</translation>
        </message>
        <message>
            <source>{0} restarted while it was asked</source>
            <translation>{0} reiniciou enquanto era consultado</translation>
        </message>
        <message>
            <source>{0} runs grbl {1}</source>
            <translation>{0} usa grbl {1}</translation>
        </message>
        <message>
            <source>{0} sends no line ends</source>
            <translation>{0} não envia fins de linha</translation>
        </message>
        <message>
            <source>{0} to {1} mm</source>
            <translation>{0} a {1} mm</translation>
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
</TS>
